#include "host_sim/scene_file/loaded_mesh.hpp"

#include <filesystem>

#include "host_sim/engine/model_scene.hpp"
#include "host_sim/error.hpp"
#include "host_sim/model/obj_import.hpp"

namespace shade16::host {

namespace {

/// Arrays for a shape, filled by the core's own generator.
template <class Fill>
BakedPart filled(uint32_t vertices, uint32_t triangles, Fill fill) {
    BakedPart part;
    part.positions.resize(vertices), part.normals.resize(vertices), part.triangles.resize(triangles);
    if constexpr (requires { fill(detail::ShapeArrays{}, nullptr); }) {
        part.texcoords.resize(vertices);
        fill(detail::ShapeArrays{part.positions.data(), part.normals.data(), part.triangles.data()}, part.texcoords.data());
    } else {
        fill(detail::ShapeArrays{part.positions.data(), part.normals.data(), part.triangles.data()});
    }
    return part;
}

template <class Shape>
BakedPart copied(const Shape& shape) {
    const Mesh mesh = shape.mesh();
    BakedPart part;
    part.positions.assign(mesh.positions.begin(), mesh.positions.end());
    part.normals.assign(mesh.normals.begin(), mesh.normals.end());
    part.texcoords.assign(mesh.texcoords.begin(), mesh.texcoords.end());
    part.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
    part.convex = mesh.convex;
    return part;
}

BakedPart textured_shape_of(const MeshDescription& m) {
    if (m.kind == ShapeKind::cube) return copied(textured_cube);
    if (m.kind == ShapeKind::quad) return copied(textured_quad);
    const uint32_t vertices = detail::grid_vertices(m.around, m.along);
    if (m.kind == ShapeKind::sphere)
        return filled(vertices, detail::sphere_triangles(m.around, m.along), [&](const detail::ShapeArrays& to, TexCoord16* at) {
            detail::fill_textured_sphere(to, at, m.around, m.along);
        });
    return filled(vertices, 2 * m.around * m.along, [&](const detail::ShapeArrays& to, TexCoord16* at) {
        detail::fill_textured_torus(to, at, m.around, m.along, m.minor_radius);
    });
}

BakedPart shape_of(const MeshDescription& m) {
    if (m.kind == ShapeKind::cube) return copied(cube);
    if (m.kind == ShapeKind::quad) return copied(quad);
    if (m.kind == ShapeKind::sphere)
        return filled(detail::sphere_vertices(m.around, m.along), detail::sphere_triangles(m.around, m.along),
                      [&](const detail::ShapeArrays& to) { detail::fill_sphere(to, m.around, m.along); });
    return filled(m.around * m.along, 2 * m.around * m.along,
                  [&](const detail::ShapeArrays& to) { detail::fill_torus(to, m.around, m.along, m.minor_radius); });
}

Error at_line(const MeshDescription& m, const std::string& scene_path, ExitCode code, const std::string& complaint) {
    return {code, fmt::format("{}:{}: mesh '{}': {}", scene_path, m.line, m.name, complaint)};
}

}  // namespace

LoadedMesh load_mesh(const MeshDescription& m, const std::string& scene_path, bool is_textured) {
    LoadedMesh mesh;
    if (m.kind == ShapeKind::file) try {
            mesh.model = import_obj((std::filesystem::path(scene_path).parent_path() / m.file).string(), m.crease_degrees, is_textured);
            mesh.baked = quantize(*mesh.model);
            return mesh;
        } catch (const Error& error) {
            throw at_line(m, scene_path, error.code, error.what());
        }
    mesh.baked.source = m.name;
    mesh.baked.fraction_bits = m.kind == ShapeKind::torus ? detail::torus_fraction_bits : int8_t{14};
    const bool has_grid = m.kind == ShapeKind::sphere || m.kind == ShapeKind::torus;
    if (const uint32_t vertices = detail::grid_vertices(m.around, m.along); is_textured && has_grid && vertices > max_mesh_vertices)
        throw at_line(m, scene_path, ExitCode::input,
                      fmt::format("has {} vertices with a texture; expected at most {}.", vertices, max_mesh_vertices));
    mesh.baked.parts.push_back(is_textured ? textured_shape_of(m) : shape_of(m));
    BakedPart& part = mesh.baked.parts.front();
    part.name = m.name;
    part.colors = m.colors;
    if (!m.colors.empty() && m.colors.size() != part.positions.size())
        throw at_line(m, scene_path, ExitCode::input,
                      fmt::format("'colors' has {} elements; expected {}, one a vertex.", m.colors.size(),
                                  part.positions.size()));
    return mesh;
}

std::vector<reference::Mesh> LoadedMesh::originals() const {
    std::vector<reference::Mesh> all;
    if (!model) {
        for (std::size_t i = 0; i < baked.parts.size(); ++i) all.push_back(reference::value(mesh_of(baked, i)));
        return all;
    }
    return original_meshes(*model, baked);
}

}  // namespace shade16::host
