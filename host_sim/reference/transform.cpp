#include "host_sim/reference/transform.hpp"

#include <algorithm>

namespace shade16::reference {

namespace {
glm::dmat3 look_rotation(const Camera& camera) {
    glm::dvec3 back = value(camera.eye) - value(camera.target);
    back = glm::length(back) == 0 ? glm::dvec3(0, 0, 1) : glm::normalize(back);
    glm::dvec3 right = glm::cross(value(camera.up), back);
    if (glm::length(right) < 1e-8) {
        const glm::dvec3 a = glm::abs(back);
        right = glm::cross(a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0) : a.y <= a.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), back);
    }
    right = glm::normalize(right);
    return glm::transpose(glm::dmat3(right, glm::cross(back, right), back));
}
}  // namespace

View make_view(const Camera& camera, Viewport viewport) {
    View view;
    view.rotation = reference::look_rotation(camera);
    view.eye = value(camera.eye);
    view.perspective = camera.projection == Projection::perspective;
    view.focal_px = view.perspective ? viewport.height / 2.0 / std::tan(radians(camera.fov_y) / 2)
                                     : viewport.height / value(camera.view_height);
    view.near_distance = value(camera.near_distance);
    view.far_distance = value(camera.far_distance);
    view.viewport = viewport;
    return view;
}

glm::dvec3 to_world(const Pose& pose, const glm::dvec3& position) {
    return value(pose.rotation) * (value(pose.scale) * position) + value(pose.translation);
}

glm::dvec3 normal_to_world(const Pose& pose, const glm::dvec3& normal) {
    const glm::dvec3 n = value(pose.rotation) * (normal / value(pose.scale));
    const double length = glm::length(n);
    return length == 0 ? n : n / length;
}

glm::dvec3 to_view(const View& view, const glm::dvec3& position_world) { return view.rotation * (position_world - view.eye); }

ScreenPoint project(const View& view, const glm::dvec3& p) {
    const double distance = -p.z, near = view.near_distance, far = view.far_distance;
    const double w = view.perspective ? distance : 1.0;
    const double depth = view.perspective ? far / (far - near) * (1 - near / distance) : (distance - near) / (far - near);
    return {{view.viewport.width / 2.0 + view.focal_px * p.x / w, view.viewport.height / 2.0 - view.focal_px * p.y / w},
            std::clamp(depth, 0.0, 1.0)};
}

glm::dvec3 ray_through(const View& view, const glm::dvec2& p) {
    const glm::dvec2 from_centre = p - glm::dvec2(view.viewport.width, view.viewport.height) / 2.0;
    return {from_centre.x / view.focal_px, -from_centre.y / view.focal_px, -1};
}

}  // namespace shade16::reference
