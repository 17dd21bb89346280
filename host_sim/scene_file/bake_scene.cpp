#include "host_sim/scene_file/bake_scene.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "host_sim/model/header_text.hpp"
#include "host_sim/model/identifier.hpp"
#include "host_sim/model/map_texts.hpp"
#include "host_sim/report/memory.hpp"
#include "host_sim/scene_file/scene_values.hpp"
#include "host_sim/scene_file/shape_text.hpp"

namespace shade16::host {

namespace {

constexpr int frames_of_a_turn = 90;  // where the scene file does not say

const std::string no_suffix[] = {""};
const std::string array_suffixes[] = {"", "_positions", "_normals", "_colors", "_texcoords", "_triangles"};

std::string list(const char* type, const char* name, const std::vector<std::string>& elements) {
    if (elements.empty()) return {};
    std::string text = fmt::format("\ninline constexpr shade16::{} {}[] = {{\n", type, name);
    for (const std::string& element : elements) text += "    " + element + ",\n";
    return text + "};\n";
}

std::string pixel_name(const TargetFormat& target) {
    const std::map<std::string, std::string> names{
        {Rgb565::name, "Rgb565"}, {Rgb565Swapped::name, "Rgb565Swapped"}, {Rgb888::name, "Rgb888"},
        {Gray8::name, "Gray8"},   {Gray4::name, "Gray4"},                 {Mono1::name, "Mono1"}};
    const std::string name = "shade16::" + names.at(target.format);
    if (target.dither == dither_names[0]) return name;
    return fmt::format("shade16::Dithered<{}, shade16::{}>", name, target.dither == "4x4" ? "bayer4" : "bayer8");
}

/// A part of a mesh that is drawn, and whether its objects may rely on its being convex.
struct DrawnPart {
    std::size_t mesh = 0, part = 0;
    std::vector<bool> convex{};  // the distinct values, in the order of the objects
};

std::vector<DrawnPart> drawn_parts(const LoadedScene& scene) {
    std::vector<DrawnPart> all;
    for (std::size_t i = 0; i < scene.origins().size(); ++i) {
        const auto& origin = scene.origins()[i];
        auto at = std::find_if(all.begin(), all.end(),
                               [&](const DrawnPart& d) { return d.mesh == origin.mesh && d.part == origin.part; });
        if (at == all.end()) at = all.insert(at, {origin.mesh, origin.part});
        const bool convex = scene.scene().objects[static_cast<uint32_t>(i)].mesh.convex;
        if (std::find(at->convex.begin(), at->convex.end(), convex) == at->convex.end()) at->convex.push_back(convex);
    }
    return all;
}

class SceneHeader {
public:
    SceneHeader(const LoadedScene& scene, std::string name) : loaded_(scene), name_(std::move(name)) {
        for (const char* own :
             {"scene", "viewport", "frames", "spins", "lights", "objects", "Pixel", "Tier", "uint32_t"})
            names_.claim(own, no_suffix);
    }

    std::string text() {
        std::string text = preamble();
        text += meshes();     // these two
        text += materials();  // give the names that objects() uses
        text += list("Light", "lights", lights());
        text += list("Spin", "spins", spins());
        text += list("Object", "objects", objects());
        return text + scene() + output() + fmt::format("\n}}  // namespace assets::{}\n", name_);
    }

private:
    std::string preamble() const {
        const MeshFigures sum = mesh_figures(loaded_);
        return fmt::format(
            "// Made by: shade16 bake {} -o {}.hpp\n"
            "// {} vertices, {} triangles, {} bytes of flash.\n"
            "#pragma once\n\n#include <shade16/shade16.hpp>\n\nnamespace assets::{} {{\n",
            harmless(loaded_.source()), name_, sum.vertices, sum.triangles, sum.flash_bytes, name_);
    }

    std::string meshes() {
        std::string text;
        for (const DrawnPart& drawn : drawn_parts(loaded_)) text += mesh(drawn);
        return text;
    }

    /// The arrays once, and a Mesh for each of the values of `convex`.
    std::string mesh(const DrawnPart& drawn) {
        const MeshDescription& description = loaded_.description().meshes[drawn.mesh];
        const BakedModel& baked = loaded_.meshes()[drawn.mesh].baked;
        const BakedPart& part = baked.parts[drawn.part];
        const std::string wish = baked.parts.size() == 1 ? description.name : description.name + "_" + part.name;
        const std::string& stem = stems_[{drawn.mesh, drawn.part}] = names_.claim(identifier(wish), array_suffixes);
        const std::string shape = drawn.convex == std::vector<bool>{part.convex} ? shape_text(description, !part.texcoords.empty()) : "";

        std::string text = fmt::format("\n// {}: {} vertices, {} triangles, {} bytes of flash.\n", stem,
                                       part.positions.size(), part.triangles.size(), part.flash_bytes());
        if (shape.empty()) text += arrays_text(part, stem);
        for (const bool convex : drawn.convex) {
            const bool is_first = convex == drawn.convex.front();
            const std::string name =
                is_first ? stem : names_.claim(stem + (convex ? "_convex" : "_not_convex"), no_suffix);
            text += fmt::format("inline constexpr shade16::Mesh {}{};\n", name,
                                shape.empty() ? mesh_text(baked, part, stem, convex) : " = " + shape);
            mesh_names_[{drawn.mesh, drawn.part, convex}] = name;
        }
        return text;
    }

    /// The name of an object's Mesh.
    const std::string& mesh_of(std::size_t object) const {
        const auto& origin = loaded_.origins()[object];
        return mesh_names_.at({origin.mesh, origin.part, drawn(object).mesh.convex});
    }

    const BakedPart& part_of(std::size_t object) const {
        const auto& origin = loaded_.origins()[object];
        return loaded_.meshes()[origin.mesh].baked.parts[origin.part];
    }

    /// The name of its arrays, whatever it says of being convex.
    const std::string& stem_of(std::size_t object) const {
        return stems_.at({loaded_.origins()[object].mesh, loaded_.origins()[object].part});
    }

    std::string materials() {
        std::string text;
        for (std::size_t i = 0; i < loaded_.origins().size(); ++i) {
            const ObjectDescription& object = loaded_.description().objects[loaded_.origins()[i].object];
            const bool has_name = object.value && !object.material.empty();
            const std::string& wish = has_name ? object.material : stem_of(i);
            // What a scene file calls 'quad' is another material than the mesh's own.
            std::string& name = material_names_[{has_name, wish}];
            if (name.empty()) {
                name = names_.claim(identifier(wish + "_material"), no_suffix);
                const MapNames maps = maps_.names_of(object.value ? object.maps : part_of(i).maps, text);
                text += fmt::format("\ninline constexpr shade16::Material {}{};\n", name, material_text(drawn(i).material, maps));
            }
            material_of_object_.push_back(name);
        }
        return text;
    }

    std::vector<std::string> lights() const {
        std::vector<std::string> all;
        for (const Light& light : loaded_.scene().lights) all.push_back(light_text(light));
        return all;
    }

    std::vector<std::string> spins() const {
        std::vector<std::string> all;
        for (std::size_t i = 0; i < loaded_.spins().size(); ++i)
            all.push_back(
                spin_text(loaded_.spins()[i], loaded_.description().objects[loaded_.origins()[i].object].rotation));
        return all;
    }

    std::vector<std::string> objects() const {
        std::vector<std::string> all;
        for (std::size_t i = 0; i < loaded_.origins().size(); ++i)
            all.push_back(fmt::format("{{.mesh = {}, .material = {}, .pose = spins[{}].at({{}})}}", mesh_of(i),
                                      material_of_object_[i], i));
        return all;
    }

    const Object& drawn(std::size_t object) const { return loaded_.scene().objects[static_cast<uint32_t>(object)]; }

    std::string scene() const {
        const Scene& s = loaded_.scene();
        Fields to(field_columns);
        if (const std::string camera = camera_text(s.camera); camera != "{}") to.add("camera", camera);
        if (!s.lights.empty()) to.add("lights", "lights");
        to.add("objects", "objects");
        if (s.background != black) to.add("background", literal(s.background));
        return "\ninline constexpr shade16::Scene scene" + to.braced() + ";\n";
    }

    std::string output() const {
        const OutputSettings& o = loaded_.description().output;
        return fmt::format(
            "\ninline constexpr shade16::Viewport viewport{{{}, {}}};\n"
            "inline constexpr uint32_t frames = {};\n"
            "using Pixel = {};\n"
            "using Tier = shade16::{};\n",
            o.size.width, o.size.height, baked_frames(loaded_), pixel_name(o.target), o.tier);
    }

    const LoadedScene& loaded_;
    std::string name_;
    UniqueNames names_{};
    MapTexts maps_{names_};
    std::map<std::pair<std::size_t, std::size_t>, std::string> stems_{};
    std::map<std::tuple<std::size_t, std::size_t, bool>, std::string> mesh_names_{};
    std::map<std::pair<bool, std::string>, std::string> material_names_{};
    std::vector<std::string> material_of_object_{};
};

}  // namespace

std::string bake_scene_header(const LoadedScene& scene, std::string_view name) {
    return SceneHeader(scene, identifier(name)).text();
}

int baked_frames(const LoadedScene& scene) {
    if (scene.description().output.frames > 0) return scene.description().output.frames;
    const auto turns = [](const Spin& spin) { return spin.turns != Q16{}; };
    return std::any_of(scene.spins().begin(), scene.spins().end(), turns) ? frames_of_a_turn : 1;
}

MeshFigures mesh_figures(const LoadedScene& scene) {
    MeshFigures sum;
    for (const DrawnPart& drawn : drawn_parts(scene)) {
        const BakedPart& part = scene.meshes()[drawn.mesh].baked.parts[drawn.part];
        sum.vertices += part.positions.size();
        sum.triangles += part.triangles.size();
        sum.flash_bytes += part.flash_bytes();
    }
    sum.flash_bytes += picture_bytes(scene.scene());
    return sum;
}

}  // namespace shade16::host
