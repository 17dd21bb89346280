#include "host_sim/reference/pipeline.hpp"

#include "host_sim/reference/normals.hpp"
#include "host_sim/reference/texture.hpp"

#include <algorithm>
#include <array>

namespace shade16::reference {

namespace {

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
    return light_point(values.camera, values.lights, values.material(scene.values, object), pose, point);
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
    return light_point(values.camera, values.lights, values.material(scene.values, object), pose, point);
}

namespace {
/// A face with its corners' places in the texture, if it has one.
struct FaceCorners {
    std::array<uint32_t, 3> index;
    std::array<glm::dvec2, 3> at{};

    FaceCorners(const Mesh& mesh, uint32_t face) : index{mesh.triangles[face].a, mesh.triangles[face].b, mesh.triangles[face].c} {
        for (std::size_t k = 0; k < 3 && !mesh.texcoords.empty(); ++k) at[k] = mesh.texcoords[index[k]];
    }
};

/// The colour and the slopes that an object's maps have at a point of a face.
struct MapValues {
    glm::dvec3 color{1};
    glm::dvec2 slope{};

    MapValues(const Object& object, const FaceCorners& face, const FacePoint& at, bool perspective) {
        const Material& m = object.material;
        const glm::dvec2 place = texture_coordinates(face.at, at, perspective && m.mapping == Mapping::perspective);
        const auto shifted = [&](const auto& map) { return place + at.texel_shift / glm::dvec2(1 << map.width_log2, 1 << map.height_log2); };
        if (detail::has_texture(object)) color = texture_color(*m.texture, m.filter, shifted(*m.texture));
        if (detail::has_bump(object)) slope = relief_slope(*m.bump, m.filter, shifted(*m.bump));
    }
};

LightParts light_phong_surface(const Scene& scene, const Frame& frame, std::size_t o, const FaceCorners& face, const FacePoint& at, const MapValues& maps,
                               Channels channels) {
    const FrameValues values(scene.values, frame);
    const Object& object = scene.values.objects[static_cast<uint32_t>(o)];
    const Mesh& mesh = scene.meshes[o];
    const Pose& pose = values.pose(scene.values, o);
    std::array<glm::dvec3, 3> normals{}, positions{};
    SurfacePoint point;
    point.position = glm::dvec3(0);
    if (!mesh.colors.empty()) point.color = glm::dvec3(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const double weight = at.weights[static_cast<int>(k)];
        positions[k] = to_world(pose, mesh.positions[face.index[k]]);
        point.position += weight * positions[k];
        if (!mesh.normals.empty()) normals[k] = normal_to_world(pose, mesh.normals[face.index[k]]);
        if (!mesh.colors.empty()) point.color += weight * mesh.colors[face.index[k]];
    }
    point.color = in_channels(point.color, channels) * in_channels(maps.color, channels);
    if (at.on_table_map) point.normal = mapped_normal(normals, at.weights, reference::make_view(values.camera, {1, 1}).rotation);
    else point.normal = object.material.normal_path == NormalPath::spherical ? spherical_normal(normals, at) : linear_normal(normals, at.weights);
    if (detail::has_bump(object) && point.normal != glm::dvec3(0)) {
        const Tangents tangents = face_tangents(positions, face.at);
        point.normal = glm::normalize(point.normal + maps.slope.x * tangents.along_s + maps.slope.y * tangents.along_t);
    }
    return in_channels(light_point(values.camera, values.lights, values.material(scene.values, o), pose, point), channels);
}

/// Light of the corners, interpolated in two sums. The one share left stands for all that arrives.
LightParts interpolated_light(const std::array<LightParts, 3>& corner, const glm::dvec3& weights) {
    LightParts sum;
    LightShare share;
    share.n_dot_l = 1;
    for (int k = 0; k < 3; ++k) {
        const LightParts& parts = corner[static_cast<std::size_t>(k)];
        glm::dvec3 body = parts.base, shine(0);
        double arriving = 0;
        for (const LightShare& s : parts.shares) {
            body += s.diffuse;
            if (s.n_dot_l > 0) shine += s.specular;
            arriving += s.arriving;
            share.half_length = std::min(share.half_length, s.half_length);
        }
        sum.base += weights[k] * parts.color * body;
        share.specular += weights[k] * shine;
        share.arriving = std::max(share.arriving, arriving);
    }
    sum.shares.push_back(share);
    return sum;
}
}  // namespace

bool is_by_pixel(const Object& object) { return detail::is_phong(object.material) || detail::has_texture(object); }

LightParts light_surface(const Scene& scene, const Frame& frame, std::size_t o, uint32_t f, const FacePoint& at, Channels channels) {
    const Object& object = scene.values.objects[static_cast<uint32_t>(o)];
    const FaceCorners face(scene.meshes[o], f);
    const MapValues maps(object, face, at, FrameValues(scene.values, frame).camera.projection == Projection::perspective);
    if (detail::is_phong(object.material)) return light_phong_surface(scene, frame, o, face, at, maps, channels);
    std::array<LightParts, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = in_channels(detail::is_flat(object.material) ? light_face(scene, frame, o, f) : light_vertex(scene, frame, o, face.index[k]), channels);
    LightParts parts = interpolated_light(corners, at.weights);
    parts.color = in_channels(maps.color, channels);
    return parts;
}

Picture draw(const Scene& scene, const Frame& frame, Viewport viewport, Channels channels) {
    const auto saturated = [channels](const LightParts& parts) { return glm::clamp(in_channels(parts, channels).sum(), 0.0, 1.0); };
    const FrameValues values(scene.values, frame);
    const View view = reference::make_view(values.camera, viewport);
    Picture picture(viewport, in_channels(value(scene.values.background), channels));
    for (std::size_t o = 0; o < scene.meshes.size(); ++o) {
        const Mesh& mesh = scene.meshes[o];
        const Material material = values.material(scene.values, o);
        const bool flat = detail::is_flat(material), by_pixel = is_by_pixel(scene.values.objects[static_cast<uint32_t>(o)]);
        std::vector<Corner> corners;
        for (uint32_t i = 0; i < mesh.positions.size(); ++i)
            corners.push_back({to_view(view, to_world(values.pose(scene.values, o), mesh.positions[i])),
                               flat || by_pixel ? glm::dvec3(0) : saturated(light_vertex(scene, frame, o, i))});
        for (uint32_t f = 0; f < mesh.triangles.size(); ++f) {
            const Triangle t = mesh.triangles[f];
            std::array<Corner, 3> triangle{corners[t.a], corners[t.b], corners[t.c]};
            if (flat && !by_pixel)
                for (Corner& c : triangle) c.color = saturated(light_face(scene, frame, o, f));
            FacePoint point;
            glm::dmat3 corner_view(1);
            for (int k = 0; by_pixel && k < 3; ++k) {
                Corner& corner = triangle[static_cast<std::size_t>(k)];
                corner.color = glm::dvec3(k == 0, k == 1, k == 2);
                point.corner_px[static_cast<std::size_t>(k)] = project(view, corner.position_view).position;
                corner_view[k] = corner.position_view;
            }
            const glm::dmat3 to_weights = glm::inverse(corner_view);
            const Shade shade = [&](const glm::dvec3& weights, const glm::dvec2& pixel) {
                point.weights = weights;
                point.weights_in_space = to_weights * ray_through(view, pixel);
                return saturated(light_surface(scene, frame, o, f, point, channels));
            };
            draw_triangle(picture, view, triangle, by_pixel ? shade : Shade{});
        }
    }
    return picture;
}

}  // namespace shade16::reference
