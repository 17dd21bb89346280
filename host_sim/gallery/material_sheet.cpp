#include "host_sim/gallery/material_sheet.hpp"

#include <algorithm>

#include "host_sim/engine/turntable.hpp"
#include "host_sim/gallery/canvas.hpp"
#include "host_sim/gallery/font.hpp"
#include "host_sim/gallery/heat_map.hpp"

namespace shade16::host {

namespace {

constexpr int columns = 6, rows = 4, margin_px = 8, caption_px = glyph_height_px + 10;
static_assert(columns * rows == sizeof classic_materials / sizeof classic_materials[0]);

/// A sphere in the light of the table's origin: teapots.c has a white light from (0, 3, 3), here moved to the left, and
/// ambient light of 0.2.
class Swatch final : public AnimatedScene {
public:
    explicit Swatch(const Material& material) : object_{sphere<48, 24>.mesh(), material, {}} {
        scene_ = {.camera = {.eye = {0, 0, 4},
                             .projection = Projection::orthographic,
                             .view_height = 2.2_q16,
                             .near_distance = 2,
                             .far_distance = 6},
                  .lights = lights,
                  .objects = {&object_, 1},
                  .background = rgb(0x101820)};
    }

    const Scene& scene() const override { return scene_; }
    std::vector<Pose> poses(Angle) const override { return {object_.pose}; }
    reference::Scene unquantized() const override { return {scene_, {reference::value(object_.mesh)}}; }
    const std::string& source() const override { return name_; }
    const std::vector<std::string>& warnings() const override { return warnings_; }

private:
    static constexpr Light lights[] = {ambient_light(rgb(0x333333)), directional_light({-2, 3, 3}, white, 1_scaled)};

    Object object_;
    Scene scene_{};
    std::string name_ = "swatch";
    std::vector<std::string> warnings_{};
};

int cell_width(Viewport swatch) {
    int widest = swatch.width;
    for (const NamedMaterial& row : classic_materials) widest = std::max(widest, text_width_px(row.name));
    return widest + margin_px;
}

int cell_height(Viewport swatch) { return swatch.height + caption_px; }

Viewport sheet_size(Viewport swatch) {
    return {columns * cell_width(swatch) + margin_px, rows * cell_height(swatch) + margin_px};
}

/// A sheet of what `draw` makes of each material's scene.
template <class Draw>
Image sheet_of(Viewport swatch, std::optional<Shading> shading, Draw draw) {
    const Viewport size = sheet_size(swatch);
    Canvas canvas(size.width, size.height);
    int x = margin_px, y = margin_px;
    for (const NamedMaterial& row : classic_materials) {
        Material material = row.material;
        if (shading) material.shading = *shading;
        const Swatch scene(material);
        const int room = cell_width(swatch) - margin_px;
        canvas.put(draw(scene), x + (room - swatch.width) / 2, y);
        canvas.write(row.name, x + (room - text_width_px(row.name)) / 2, y + swatch.height + 3);
        x += cell_width(swatch);
        if (x + margin_px >= size.width) x = margin_px, y += cell_height(swatch);
    }
    return canvas.image();
}

}  // namespace

Viewport material_sheet_size(Viewport swatch) { return sheet_size(swatch); }

Image material_sheet(Viewport swatch, std::string_view tier, std::optional<Shading> shading) {
    return sheet_of(swatch, shading, [&](const AnimatedScene& scene) {
        return fixed_turntable(scene, swatch, tier, {Rgb888::name, dither_names[0]}, 0)->draw({});
    });
}

Image material_error_sheet(Viewport swatch, Shading shading, ReferenceDifference& all) {
    all = {};
    return sheet_of(swatch, shading, [&](const AnimatedScene& scene) {
        const ReferenceDifference error = difference_from_reference(scene, {}, swatch, Component::all, false);
        all.add(error);
        return heat_map(error);
    });
}

}  // namespace shade16::host
