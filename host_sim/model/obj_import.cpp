#include "host_sim/model/obj_import.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "host_sim/error.hpp"
#include "host_sim/model/mtl_import.hpp"
#include "host_sim/model/obj_text.hpp"
#include "host_sim/model/polygon.hpp"
#include "host_sim/model/smooth_normals.hpp"
#include "host_sim/model/text_lines.hpp"

namespace shade16::host {

namespace {

/// What tinyobjloader made of the file: all faces in one shape, in the order of the file.
struct Parsed {
    tinyobj::attrib_t attributes{};
    tinyobj::mesh_t mesh{};
    std::vector<tinyobj::material_t> materials{};
};

Double3 triple(const std::vector<tinyobj::real_t>& values, int index) {
    const std::size_t i = 3 * static_cast<std::size_t>(index);
    return {values[i], values[i + 1], values[i + 2]};
}

Parsed parse(const std::string& path, const ObjText& text, MtlReader& materials) {
    Parsed parsed;
    std::vector<tinyobj::shape_t> shapes;
    std::string warning, error;
    std::istringstream lines("mtllib all\n" + text.lines);  // first: some files name their libraries after a usemtl
    const bool ok =
        tinyobj::LoadObj(&parsed.attributes, &shapes, &parsed.materials, &warning, &error, &lines, &materials, false);
    if (!ok || shapes.size() != 1) throw input_error("{}: is no valid OBJ file. {}", path, error);
    for (const auto coordinate : parsed.attributes.vertices)
        if (!std::isfinite(coordinate))
            throw input_error("{}: a coordinate is not finite; expected -16384 to 16384.", path);
    parsed.mesh = std::move(shapes[0].mesh);
    return parsed;
}

class Builder {
public:
    Builder(const Parsed& parsed, const ObjText& text, const std::string& directory, std::optional<double> crease_degrees, bool with_texcoords, Model& model)
        : parsed_(parsed), directory_(directory), model_(model), has_texcoords_(with_texcoords), has_smoothing_(text.has_smoothing), keeps_normals_(!crease_degrees),
          normals_(crease_degrees.value_or(180)), bad_normals_(parsed.attributes.normals.size() / 3) {
        const auto& colors = parsed.attributes.colors;
        const bool colored = std::any_of(colors.begin(), colors.end(), [](auto channel) { return channel != 1; });
        colored_ = colored && colors.size() == parsed.attributes.vertices.size();
    }

    void build() {
        for (const int material : parsed_.mesh.material_ids) {
            const ModelPart& part = part_of(material);
            has_texcoords_ = has_texcoords_ || part.material.texture != nullptr || part.material.bump != nullptr;
        }
        if (has_texcoords_ && parsed_.attributes.texcoords.empty())
            model_.warnings.push_back("The model has pictures, but no vt lines: each picture shows one texel everywhere.");
        for_each_face([this](std::size_t face, std::size_t) { normals_.add_face(corners_, group_of(face)); });
        for_each_face([this](std::size_t face, std::size_t first) { add_face(face, first); });
        std::erase_if(model_.parts, [](const ModelPart& part) { return part.triangles.empty(); });
        const std::vector<std::string> sentences = remarks_.sentences();
        model_.warnings.insert(model_.warnings.end(), sentences.begin(), sentences.end());
        model_.replaced_normals += static_cast<std::size_t>(std::count(bad_normals_.begin(), bad_normals_.end(), true));
    }

private:
    template <class Visit>
    void for_each_face(Visit visit) {
        std::size_t first = 0;
        for (std::size_t face = 0; face < parsed_.mesh.num_face_vertices.size(); ++face) {
            const std::size_t corners = parsed_.mesh.num_face_vertices[face];
            corners_.clear();
            for (std::size_t i = 0; i < corners; ++i)
                corners_.push_back(triple(parsed_.attributes.vertices, parsed_.mesh.indices[first + i].vertex_index));
            visit(face, first);
            first += corners;
        }
    }

    /// Without any smoothing group in the file, everything is smooth.
    unsigned group_of(std::size_t face) const { return has_smoothing_ ? parsed_.mesh.smoothing_group_ids[face] : 1; }

    void add_face(std::size_t face, std::size_t first) {
        const std::optional<Double3> face_normal = direction(area_vector(corners_));
        for (const auto& [a, b, c] : triangulate(corners_)) {
            if (is_degenerate(corners_[a], corners_[b], corners_[c])) {
                ++model_.degenerate_triangles;
                continue;
            }
            const std::array<Double3, 3> triangle{corners_[a], corners_[b], corners_[c]};
            const Double3 normal =
                face_normal ? *face_normal : direction(area_vector(triangle)).value_or(Double3{0, 0, 1});
            const auto at = [&](std::size_t i) { return vertex(parsed_.mesh.indices[first + i], corners_[i], {normal, group_of(face)}); };
            const std::array<uint32_t, 3> indices{at(a), at(b), at(c)};
            part_of(parsed_.mesh.material_ids[face]).triangles.push_back(indices);
        }
    }

    uint32_t vertex(const tinyobj::index_t& index, const Double3& position, const FaceSide& face) {
        const Double3 normal = normal_at(index, position, face);
        const Double3 color = colored_ ? triple(parsed_.attributes.colors, index.vertex_index) : Double3{1, 1, 1};
        const std::array<double, 2> at = place_at(index);
        const auto [entry, is_new] =
            vertices_.try_emplace({position, normal, color, Double3{at[0], at[1], 0}}, static_cast<uint32_t>(model_.positions.size()));
        if (is_new) {
            model_.positions.push_back(position);
            model_.normals.push_back(normal);
            if (colored_) model_.colors.push_back(color);
            if (has_texcoords_) model_.texcoords.push_back(at);
        }
        return entry->second;
    }

    std::array<double, 2> place_at(const tinyobj::index_t& index) const {
        if (!has_texcoords_ || index.texcoord_index < 0) return {0, 0};
        const std::size_t i = 2 * static_cast<std::size_t>(index.texcoord_index);
        const auto& all = parsed_.attributes.texcoords;
        const auto finite = [](double v) { return std::isfinite(v) ? v : 0; };
        return {finite(all[i]), finite(all[i + 1])};
    }

    Double3 normal_at(const tinyobj::index_t& index, const Double3& position, const FaceSide& face) {
        if (keeps_normals_ && index.normal_index >= 0) {
            if (const auto given = direction(triple(parsed_.attributes.normals, index.normal_index))) return *given;
            bad_normals_[static_cast<std::size_t>(index.normal_index)] = true;
        }
        return normals_.at(position, face).value_or(face.normal);
    }

    ModelPart& part_of(int material_id) {
        const auto [entry, is_new] = parts_.try_emplace(material_id, model_.parts.size());
        if (is_new && material_id < 0) {
            model_.parts.push_back({.name = "default", .material = default_material()});
        } else if (is_new) {
            model_.parts.push_back(to_part(parsed_.materials[static_cast<std::size_t>(material_id)], directory_, remarks_, pictures_, model_.warnings));
        }
        return model_.parts[entry->second];
    }

    const Parsed& parsed_;
    const std::string& directory_;
    Model& model_;
    Pictures pictures_{model_.warnings};
    bool has_texcoords_, colored_ = false, has_smoothing_, keeps_normals_;
    std::vector<Double3> corners_{};  // of the face at hand
    SmoothNormals normals_;
    std::vector<bool> bad_normals_;
    std::map<std::array<Double3, 4>, uint32_t> vertices_{};
    std::map<int, std::size_t> parts_{};
    Remarks remarks_{};  // on materials
};

void warn_of_missing_materials(const ObjText& text, const Parsed& parsed, Model& model) {
    if (parsed.materials.empty()) return;  // an OBJ file alone, or its library is missing, which was said before
    for (const std::string& name : text.materials) {
        const bool known = std::any_of(parsed.materials.begin(), parsed.materials.end(),
                                       [&](const auto& material) { return material.name == joined_name(name); });
        if (!known)
            model.warnings.push_back(
                fmt::format("The material '{}' is in no material library; it is drawn in neutral grey.", name));
    }
}

void warn_of_repairs(const ObjText& text, Model& model) {
    const auto count = [](std::size_t n, const char* one, const char* many) {
        return fmt::format("{} {}", n, n == 1 ? one : many);
    };
    if (model.degenerate_triangles > 0)
        model.warnings.push_back(count(model.degenerate_triangles, "triangle without area was skipped.",
                                       "triangles without area were skipped."));
    if (model.replaced_normals > 0)
        model.warnings.push_back(count(model.replaced_normals,
                                       "normal without a direction was replaced by the mean of its faces.",
                                       "normals without a direction were replaced by the mean of their faces."));
    if (text.not_faces > 0)
        model.warnings.push_back(
            count(text.not_faces, "line, point or curve is not drawn.", "lines, points and curves are not drawn."));
}

}  // namespace

Model import_obj(const std::string& path, std::optional<double> crease_degrees, bool with_texcoords) {
    const ObjText text = check_obj_text(path, read_text(path));
    if (text.faces == 0) throw input_error("{}: has no faces; expected at least one line such as 'f 1 2 3'.", path);

    Model model;
    model.texcoords_for_all_parts = with_texcoords;
    model.source = std::filesystem::path(path).filename().string();
    model.degenerate_triangles = text.short_faces;
    const std::string directory = std::filesystem::path(path).parent_path().string();
    MtlReader materials(directory, text.libraries, model.warnings);
    const Parsed parsed = parse(path, text, materials);
    warn_of_missing_materials(text, parsed, model);
    Builder(parsed, text, directory, crease_degrees, with_texcoords, model).build();
    warn_of_repairs(text, model);
    if (model.parts.empty())
        throw input_error("{}: has {} faces, but none has an area; expected at least one that does.", path, text.faces);
    return model;
}

}  // namespace shade16::host
