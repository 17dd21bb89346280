// Stage 1 in double precision: from the object's coordinates to the screen. Same names and order as
// core/include/shade16/pipeline/transform.hpp.
#pragma once

#include "host_sim/reference/values.hpp"
#include "shade16/pipeline/transform.hpp"

namespace shade16::reference {

/// The camera with what follows from it.
struct View {
    glm::dmat3 rotation{1.0};  // world to view
    glm::dvec3 eye{};
    double focal_px = 0;
    double near_distance = 0, far_distance = 0;
    bool perspective = true;
    Viewport viewport{};
};

View make_view(const Camera& camera, Viewport viewport);

/// rotation * (scale * v) + translation.
glm::dvec3 to_world(const Pose& pose, const glm::dvec3& position);
/// A normal by the inverse transpose, unit length; zero stays zero.
glm::dvec3 normal_to_world(const Pose& pose, const glm::dvec3& normal);

/// View coordinates: x right, y up, z back.
glm::dvec3 to_view(const View& view, const glm::dvec3& position_world);

/// Pixels from the frame's top left, y down, and the depth in [0, 1]. For positions beyond the near plane.
struct ScreenPoint {
    glm::dvec2 position{};
    double depth = 0;
};
ScreenPoint project(const View& view, const glm::dvec3& position_view);

/// The direction in view coordinates in which a pixel's position is seen in perspective.
glm::dvec3 ray_through(const View& view, const glm::dvec2& position_px);

}  // namespace shade16::reference
