#include "host_sim/reference/pipeline.hpp"

#include "host_sim/reference/normals.hpp"

#include <array>

namespace shade16::reference {

namespace {
glm::dvec3 saturated(const LightParts& parts) { return glm::clamp(parts.sum(), 0.0, 1.0); }

/// A corner in view coordinates, with its colour; with Phong shading in place of it the weights of the face's own corners.
struct Corner {
    glm::dvec3 position_view{};
    glm::dvec3 color{};
};

/// The part of a triangle beyond the near plane. Source: Sutherland and Hodgman, 1974.
std::vector<Corner> clip_near(const View& view, const std::array<Corner, 3>& triangle) {
    const auto distance = [&](const Corner& c) { return -c.position_view.z - view.near_distance; };
    std::vector<Corner> result;
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner &from = triangle[i], &to = triangle[(i + 1) % 3];
        const double a = distance(from), b = distance(to);
        if (a >= 0) result.push_back(from);
        if ((a >= 0) != (b >= 0)) {
            const double t = a / (a - b);
            result.push_back({glm::mix(from.position_view, to.position_view, t), glm::mix(from.color, to.color, t)});
        }
    }
    return result;
}

void draw_triangle(Picture& picture, const View& view, const std::array<Corner, 3>& triangle, const Shade& shade) {
    const std::vector<Corner> polygon = clip_near(view, triangle);
    const auto vertex = [&](const Corner& c) {
        const ScreenPoint p = project(view, c.position_view);
        return Vertex{p.position, p.depth, c.color};
    };
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        raster(picture, {vertex(polygon[0]), vertex(polygon[i]), vertex(polygon[i + 1])}, shade);
}
}  // namespace

LightParts light_vertex(const Scene& scene, const Frame& frame, std::size_t object, uint32_t vertex) {
    const FrameValues values(scene.values, frame);
    const Mesh& mesh = scene.meshes[object];
    const Pose& pose = values.pose(scene.values, object);
    SurfacePoint point;
    point.position = to_world(pose, mesh.positions[vertex]);
    if (!mesh.normals.empty()) point.normal = normal_to_world(pose, mesh.normals[vertex]);
    if (!mesh.colors.empty()) point.color = mesh.colors[vertex];
    return light_point(values.camera, values.lights, scene.values.objects[static_cast<uint32_t>(object)].material, pose, point);
}

LightParts light_face(const Scene& scene, const Frame& frame, std::size_t object, uint32_t face) {
    const FrameValues values(scene.values, frame);
    const Mesh& mesh = scene.meshes[object];
    const Pose& pose = values.pose(scene.values, object);
    const Triangle t = mesh.triangles[face];
    const glm::dvec3 a = mesh.positions[t.a], b = mesh.positions[t.b], c = mesh.positions[t.c];
    SurfacePoint point;
    point.position = to_world(pose, (a + b + c) / 3.0);
    point.normal = normal_to_world(pose, glm::cross(b - a, c - a));
    if (!mesh.colors.empty()) point.color = (mesh.colors[t.a] + mesh.colors[t.b] + mesh.colors[t.c]) / 3.0;
    return light_point(values.camera, values.lights, scene.values.objects[static_cast<uint32_t>(object)].material, pose, point);
}

LightParts light_surface(const Scene& scene, const Frame& frame, std::size_t object, uint32_t face, const FacePoint& at) {
    const FrameValues values(scene.values, frame);
    const Mesh& mesh = scene.meshes[object];
    const Pose& pose = values.pose(scene.values, object);
    const Triangle t = mesh.triangles[face];
    const std::array<uint32_t, 3> corners{t.a, t.b, t.c};
    std::array<glm::dvec3, 3> normals{};
    SurfacePoint point;
    point.position = glm::dvec3(0);
    if (!mesh.colors.empty()) point.color = glm::dvec3(0);
    for (int k = 0; k < 3; ++k) {
        const uint32_t corner = corners[static_cast<std::size_t>(k)];
        point.position += at.weights[k] * to_world(pose, mesh.positions[corner]);
        if (!mesh.normals.empty()) normals[static_cast<std::size_t>(k)] = normal_to_world(pose, mesh.normals[corner]);
        if (!mesh.colors.empty()) point.color += at.weights[k] * mesh.colors[corner];
    }
    const Material& material = scene.values.objects[static_cast<uint32_t>(object)].material;
    point.normal = material.normal_path == NormalPath::spherical ? spherical_normal(normals, at) : linear_normal(normals, at.weights);
    return light_point(values.camera, values.lights, material, pose, point);
}

Picture draw(const Scene& scene, const Frame& frame, Viewport viewport) {
    const FrameValues values(scene.values, frame);
    const View view = reference::make_view(values.camera, viewport);
    Picture picture(viewport, value(scene.values.background));
    for (std::size_t o = 0; o < scene.meshes.size(); ++o) {
        const Mesh& mesh = scene.meshes[o];
        const Material& material = scene.values.objects[static_cast<uint32_t>(o)].material;
        const bool flat = material.shading == Shading::flat && !material.unlit, phong = material.shading == Shading::phong && !material.unlit;
        std::vector<Corner> corners;
        for (uint32_t i = 0; i < mesh.positions.size(); ++i)
            corners.push_back({to_view(view, to_world(values.pose(scene.values, o), mesh.positions[i])),
                               flat || phong ? glm::dvec3(0) : saturated(light_vertex(scene, frame, o, i))});
        for (uint32_t f = 0; f < mesh.triangles.size(); ++f) {
            const Triangle t = mesh.triangles[f];
            std::array<Corner, 3> triangle{corners[t.a], corners[t.b], corners[t.c]};
            if (flat)
                for (Corner& c : triangle) c.color = saturated(light_face(scene, frame, o, f));
            if (phong)
                for (int k = 0; k < 3; ++k) triangle[static_cast<std::size_t>(k)].color = glm::dvec3(k == 0, k == 1, k == 2);
            std::array<glm::dvec2, 3> corner_px{};
            for (std::size_t k = 0; phong && k < 3; ++k) corner_px[k] = project(view, triangle[k].position_view).position;
            const Shade by_pixel = [&](const glm::dvec3& weights) { return saturated(light_surface(scene, frame, o, f, {weights, corner_px})); };
            draw_triangle(picture, view, triangle, phong ? by_pixel : Shade{});
        }
    }
    return picture;
}

}  // namespace shade16::reference
