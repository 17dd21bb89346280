#include "host_sim/report/winners.hpp"

#include <deque>

#include "host_sim/engine/runtime_renderer.hpp"

namespace shade16::host {

namespace {
/// A mesh taken apart, so that each face has corners of its own; at most 65535 of them.
struct Exploded {
    std::vector<Position16> positions{};
    std::vector<Rgb> colors{};
    std::vector<Triangle> triangles{};
};
constexpr uint32_t faces_per_piece = max_mesh_vertices / 3;

Exploded explode(const Mesh& mesh, uint32_t first, uint32_t last, uint32_t first_id) {
    Exploded piece;
    for (uint32_t f = first; f < last; ++f) {
        const Triangle t = mesh.triangles[f];
        const auto base = static_cast<uint16_t>(piece.positions.size());
        const uint32_t id = first_id + f - first;
        for (const uint16_t i : {t.a, t.b, t.c}) {
            piece.positions.push_back(mesh.positions[i]);
            piece.colors.push_back(rgb(id));
        }
        piece.triangles.push_back({base, static_cast<uint16_t>(base + 1), static_cast<uint16_t>(base + 2)});
    }
    return piece;
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
            pieces.push_back(explode(mesh, first, last, static_cast<uint32_t>(names.size())));
            for (uint32_t f = first; f < last; ++f) names.push_back({o, f, true});
            const Exploded& p = pieces.back();
            Object object{{.positions = {p.positions.data(), static_cast<uint32_t>(p.positions.size())},
                           .normals = {},
                           .colors = {p.colors.data(), static_cast<uint32_t>(p.colors.size())},
                           .triangles = {p.triangles.data(), static_cast<uint32_t>(p.triangles.size())},
                           .centre = mesh.centre,
                           .fraction_bits = mesh.fraction_bits},
                          {}, scene.objects[o].pose};
            object.material.unlit = true;
            object.material.diffuse = white;
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
