#include "host_sim/report/winners.hpp"

#include <deque>

#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/reference/pipeline.hpp"

namespace shade16::host {

namespace {
/// A mesh taken apart, so that each face has corners of its own; at most 65535 of them.
struct Exploded {
    std::vector<Position16> positions{};
    std::vector<Rgb> colors{};
    std::vector<TexCoord16> texcoords{};  // of objects whose pixels are made one by one
    std::vector<Triangle> triangles{};
};
constexpr uint32_t faces_per_piece = max_mesh_vertices / 3;

Exploded explode(const Mesh& mesh, bool by_pixel, uint32_t first, uint32_t last, uint32_t first_id) {
    Exploded piece;
    for (uint32_t f = first; f < last; ++f) {
        const Triangle t = mesh.triangles[f];
        const auto base = static_cast<uint16_t>(piece.positions.size());
        const uint32_t id = first_id + f - first;
        for (const uint16_t i : {t.a, t.b, t.c}) {
            piece.positions.push_back(mesh.positions[i]);
            piece.colors.push_back(rgb(id));
            if (by_pixel) piece.texcoords.push_back(mesh.texcoords.empty() ? TexCoord16{} : mesh.texcoords[i]);
        }
        piece.triangles.push_back({base, static_cast<uint16_t>(base + 1), static_cast<uint16_t>(base + 2)});
    }
    return piece;
}

constexpr uint16_t white_texel[] = {0xFFFF};
constexpr Texture white_texture{white_texel, 0, 0};

/// A material that shows the faces' numbers, and whose triangles take the path of the object's own, so that depth is the same to the bit.
Material numbering(const Object& object) {
    Material m;
    m.unlit = true;
    m.diffuse = white;
    if (!reference::is_by_pixel(object)) return m;
    m.texture = &white_texture;
    if (detail::has_texture(object) || detail::has_bump(object)) m.mapping = object.material.mapping;
    return m;
}
}  // namespace

std::vector<FaceId> winning_faces(const Scene& scene, const Frame& frame, Viewport viewport) {
    std::deque<Exploded> pieces;  // a deque: the meshes point into it
    std::vector<Object> objects;
    std::vector<FaceId> names{{}};  // id 0 is the background
    std::vector<Pose> poses;
    for (uint32_t o = 0; o < scene.objects.count; ++o) {
        const Mesh& mesh = scene.objects[o].mesh;
        for (uint32_t first = 0; first < mesh.triangles.count; first += faces_per_piece) {
            const uint32_t last = std::min(first + faces_per_piece, mesh.triangles.count);
            pieces.push_back(explode(mesh, reference::is_by_pixel(scene.objects[o]), first, last, static_cast<uint32_t>(names.size())));
            for (uint32_t f = first; f < last; ++f) names.push_back({o, f, true});
            const Exploded& p = pieces.back();
            Object object{{.positions = {p.positions.data(), static_cast<uint32_t>(p.positions.size())},
                           .normals = {},
                           .colors = {p.colors.data(), static_cast<uint32_t>(p.colors.size())},
                           .texcoords = {p.texcoords.data(), static_cast<uint32_t>(p.texcoords.size())},
                           .triangles = {p.triangles.data(), static_cast<uint32_t>(p.triangles.size())},
                           .centre = mesh.centre,
                           .fraction_bits = mesh.fraction_bits,
                           .texcoord_bits = mesh.texcoord_bits},
                          numbering(scene.objects[o]), scene.objects[o].pose};
            objects.push_back(object);
            poses.push_back(frame.poses != nullptr ? frame.poses[o] : scene.objects[o].pose);
        }
    }
    const Scene by_face{.camera = scene.camera, .lights = {}, .objects = {objects.data(), static_cast<uint32_t>(objects.size())}, .background = black};
    RuntimeRenderer<highp> renderer(by_face);
    renderer.begin({.camera = frame.camera, .lights = nullptr, .poses = poses.data()}, viewport);
    std::vector<FaceId> winners;
    for (const Rgb888::Pixel& p : renderer.draw<Rgb888>()) winners.push_back(names.at(static_cast<std::size_t>(p.r) << 16 | static_cast<std::size_t>(p.g) << 8 | p.b));
    return winners;
}

}  // namespace shade16::host
