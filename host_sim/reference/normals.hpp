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

}  // namespace shade16::reference
