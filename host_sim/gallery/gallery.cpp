// The shares that pairs are stated to differ in are about nine tenths of what was measured when the page was written.
#include "host_sim/gallery/gallery.hpp"

#include "host_sim/gallery/material_sheet.hpp"
#include "host_sim/gallery/profile.hpp"
#include "host_sim/gallery/studio.hpp"

namespace shade16::host {

namespace {

Plate shadings(const Studio& studio) {
    Plate plate{"shading.png", 3, {}, {}, {}};
    plate.panels = {studio.panel("flat", "gallery/teapot.toml", {.look = {.shading = Shading::flat}}),
                    studio.panel("Gouraud", "gallery/teapot.toml", {.look = {.shading = Shading::gouraud}}),
                    studio.panel("Phong", "gallery/teapot.toml", {.look = {.shading = Shading::phong}})};
    plate.add_pair("flat", "Gouraud", 0.28);
    plate.add_pair("Gouraud", "Phong", 0.25);
    return plate;
}

Plate components(const Studio& studio) {
    Plate plate{"components.png", 4, {}, {}, {}};
    plate.panels = {studio.panel("ambient", "gallery/torus.toml", {.component = Component::ambient}),
                    studio.panel("diffuse", "gallery/torus.toml", {.component = Component::diffuse}),
                    studio.panel("specular", "gallery/torus.toml", {.component = Component::specular}),
                    studio.panel("their sum", "gallery/torus.toml")};
    plate.add_pair("ambient", "their sum", 0.27);
    plate.add_pair("diffuse", "their sum", 0.28);
    plate.add_pair("specular", "their sum", 0.28);
    return plate;
}

Plate exponents(const Studio& studio) {
    Plate plate{"exponents.png", 4, {}, {}, {}};
    plate.panels = {studio.panel("exponent 2", "gallery/ball.toml", {.shininess = 2}),
                    studio.panel("exponent 5", "gallery/ball.toml", {.shininess = 5}),
                    studio.panel("exponent 10", "gallery/ball.toml", {.shininess = 10}),
                    studio.panel("exponent 100", "gallery/ball.toml", {.shininess = 100})};
    plate.add_pair("exponent 2", "exponent 5", 0.5);
    plate.add_pair("exponent 5", "exponent 10", 0.49);
    plate.add_pair("exponent 10", "exponent 100", 0.39);
    return plate;
}

Plate lambert_and_phong(const Studio& studio) {
    Plate plate{"lambert.png", 2, {}, {}, {}};
    plate.panels = {studio.panel("Lambert: ambient and diffuse", "gallery/still_life.toml", {.matt = true}),
                    studio.panel("Phong: and specular", "gallery/still_life.toml")};
    plate.add_pair("Lambert: ambient and diffuse", "Phong: and specular", 0.053);
    return plate;
}

Plate mach_bands(const Studio& studio) {
    Plate plate{"mach_bands.png", 2, {}, {}, {}};
    plate.panels = {studio.panel("flat: steps", "gallery/mach_bands.toml", {.look = {.shading = Shading::flat}}),
                    studio.panel("Gouraud: kinks", "gallery/mach_bands.toml", {.look = {.shading = Shading::gouraud}})};
    for (Panel& panel : plate.panels) panel.profile = profile_of_middle_row(panel.image, 100);
    plate.add_pair("flat: steps", "Gouraud: kinks", 0.43);
    return plate;
}

Plate normals(const Studio& studio) {
    Plate plate{"normals.png", 3, {}, {}, {}};
    for (const std::string of : {"torus", "ball"}) {
        const std::string scene = "gallery/coarse_" + of + ".toml";
        plate.panels.push_back(studio.panel(of + ", Gouraud", scene, {.look = {.shading = Shading::gouraud}}));
        plate.panels.push_back(studio.panel(of + ", linear normals", scene, {.look = {.normals = NormalPath::linear}}));
        plate.panels.push_back(studio.panel(of + ", spherical normals", scene, {.look = {.normals = NormalPath::spherical}}));
    }
    plate.add_pair("torus, Gouraud", "torus, linear normals", 0.24);
    plate.add_pair("torus, linear normals", "torus, spherical normals", 0.19);
    plate.add_pair("ball, Gouraud", "ball, linear normals", 0.31);
    plate.add_pair("ball, linear normals", "ball, spherical normals", 0.15);
    return plate;
}

/// Every format as it is and dithered, twice as large; the error is that of the colours before both.
Plate dithering(const Studio& studio) {
    Plate plate{"dithering.png", 3, {}, {}, {}};
    const std::string scene = "gallery/gradient.toml";
    const std::string formats[] = {Rgb565::name, Gray4::name, Mono1::name};
    for (const std::string dither : {"none", "8x8"})
        for (const std::string& format : formats)
            plate.panels.push_back(
                studio.panel(format + (dither == "none" ? "" : ", dithered " + dither), scene,
                             {.target = {format, dither}, .scale = 2, .has_error = dither != "none"}));
    plate.add_pair("rgb565", "rgb565, dithered 8x8", 0.46);
    plate.add_pair("gray4", "gray4, dithered 8x8", 0.21);
    plate.add_pair("mono1", "mono1, dithered 8x8", 0.25);
    return plate;
}

Plate scenes(const Studio& studio) {
    Plate plate{"scenes.png", 2, {}, {}, {}};
    plate.panels = {studio.panel("lamps.toml", "scenes/lamps.toml", {.size = Viewport{320, 240}}),
                    studio.panel("textured_cube.toml", "scenes/textured_cube.toml")};
    return plate;
}

Plate oled(const Studio& studio) {
    Plate plate{"oled.png", 2, {}, {}, {}};
    const std::string scene = "scenes/oled.toml", format = Gray4::name;
    plate.panels = {
        studio.panel("oled.toml, gray4 undithered", scene, {.target = {format, "none"}, .elapsed = 90_deg, .scale = 2}),
        studio.panel("oled.toml, gray4 dithered 4x4", scene,
                     {.target = {format, "4x4"}, .elapsed = 90_deg, .scale = 2, .has_error = false})};
    plate.add_pair("oled.toml, gray4 undithered", "oled.toml, gray4 dithered 4x4", 0.042);
    return plate;
}

/// The sheet of materials, and that of their errors.
void add_materials(std::vector<Plate>& plates) {
    constexpr Viewport swatch{96, 96};
    plates.push_back({"materials.png", 1, {}, {}, material_sheet(swatch, mediump::name, Shading::phong)});
    Panel all{"all 24 materials", {}, {}, ReferenceDifference{}, 1};
    const Image sheet = material_error_sheet(swatch, Shading::phong, *all.error);
    plates.push_back({"materials_error.png", 1, {std::move(all)}, {}, sheet});
}

}  // namespace

std::vector<Plate> gallery_plates(const std::string& assets) {
    const Studio studio(assets);
    std::vector<Plate> plates;
    for (const auto draw :
         {shadings, components, exponents, lambert_and_phong, mach_bands, normals, dithering, scenes, oled})
        plates.push_back(draw(studio)), compose(plates.back());
    add_materials(plates);
    return plates;
}

}  // namespace shade16::host
