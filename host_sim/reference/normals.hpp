// How Phong shading interpolates normals, in double precision.
#pragma once

#include <array>

#include "host_sim/reference/pipeline.hpp"

namespace shade16::reference {

/// The weighted sum, renormalised; zero stays zero.
glm::dvec3 linear_normal(const std::array<glm::dvec3, 3>& normals, const glm::dvec3& weights);

/// Along the two edges that the point's row crosses, then along the row: n(t) = (sin((1 - t) a) n0 + sin(t a) n1) / sin(a).
/// Source  Shoemake, Animating Rotation with Quaternion Curves, 1985.
glm::dvec3 spherical_normal(const std::array<glm::dvec3, 3>& normals, const FacePoint& at);

/// On Lambert's azimuthal equal-area map of the view, p = (x, y) / sqrt(2 (1 + z)), as light tables do; within |p| <= 0.8.
glm::dvec3 mapped_normal(const std::array<glm::dvec3, 3>& normals_world, const glm::dvec3& weights, const glm::dmat3& world_to_view);

}  // namespace shade16::reference
