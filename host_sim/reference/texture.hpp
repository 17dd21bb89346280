// Textures and reliefs in double precision, on the same texels.
#pragma once

#include <array>

#include "host_sim/reference/pipeline.hpp"
#include "shade16/scene/texture.hpp"

namespace shade16::reference {

/// A texture's colour at (s, t), which repeat; bilinear between the centres of texels.
glm::dvec3 texture_color(const Texture& texture, Filter filter, const glm::dvec2& at);

/// A relief's slopes there.
glm::dvec2 relief_slope(const SlopeMap& map, Filter filter, const glm::dvec2& at);

/// A face's texture coordinates at one of its points: affine, or linear in space.
/// Source  for the latter: Blinn, Hyperbolic Interpolation, 1992.
glm::dvec2 texture_coordinates(const std::array<glm::dvec2, 3>& corner, const FacePoint& at, bool by_depth);

/// The directions in which s and t grow on a face; zero where the texture has no area.
struct Tangents {
    glm::dvec3 along_s{}, along_t{};
};
Tangents face_tangents(const std::array<glm::dvec3, 3>& position, const std::array<glm::dvec2, 3>& at);

}  // namespace shade16::reference
