#include "host_sim/model/bake_header.hpp"

#include <array>

#include <fmt/format.h>

#include "host_sim/model/header_text.hpp"
#include "host_sim/model/identifier.hpp"
#include "host_sim/model/map_texts.hpp"

namespace shade16::host {

namespace {

std::string part_text(const BakedModel& model, const BakedPart& part, const std::string& name, const MapNames& maps) {
    std::string text =
        fmt::format("\n// {}: {} vertices, {} triangles, {} bytes of flash{}.\n", name, part.positions.size(),
                    part.triangles.size(), part.flash_bytes(), part.convex ? ", convex" : "");
    text += arrays_text(part, name);
    text += fmt::format("inline constexpr shade16::Mesh {}{};\n", name, mesh_text(model, part, name, part.convex));
    return text +
           fmt::format("inline constexpr shade16::Material {}_material{};\n", name, material_text(part.material, maps));
}

std::string preamble(const BakedModel& model, const std::string& name) {
    return fmt::format(
        "// Made by: shade16 bake {} -o {}.hpp\n"
        "// {} vertices, {} triangles, {} bytes of flash. Positions are at most {:.3g} off, normals {:.3g} degrees.\n"
        "#pragma once\n\n#include <shade16/shade16.hpp>\n\nnamespace assets {{\n",
        harmless(model.source), name, model.vertex_count(), model.triangle_count(), model.flash_bytes(),
        model.max_position_error, model.max_normal_error_degrees);
}

}  // namespace

std::string bake_header(const BakedModel& model, std::string_view name) {
    static const std::array<std::string, 7> suffixes{"",           "_positions", "_normals", "_colors",
                                                     "_texcoords", "_triangles", "_material"};
    const std::string stem = identifier(name);
    UniqueNames names;
    MapTexts maps(names);
    std::string text = preamble(model, stem);
    for (const BakedPart& part : model.parts) {
        const std::string wish = model.parts.size() == 1 ? stem : stem + "_" + identifier(part.name);
        const std::string part_name = names.claim(identifier(wish), suffixes);
        const MapNames map_names = maps.names_of(part.maps, text);
        text += part_text(model, part, part_name, map_names);
    }
    return text + "\n}  // namespace assets\n";
}

}  // namespace shade16::host
