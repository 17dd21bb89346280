// Stage 3 in double precision: ambient + Lambert + Blinn-Phong or Phong at one point, in the world. Same names and order as
// core/include/shade16/pipeline/light.hpp.
#pragma once

#include <vector>

#include "host_sim/reference/transform.hpp"

namespace shade16::reference {

/// A point of the surface in the world.
struct SurfacePoint {
    glm::dvec3 position{};
    glm::dvec3 normal{};  // unit length, or zero
    glm::dvec3 color{1};  // the vertex colour
};

/// One light's share at a point, apart so that a comparison can judge the step at N.L = 0.
struct LightShare {
    glm::dvec3 diffuse{}, specular{};  // specular as if the gate were open
    double n_dot_l = 0;
    double half_length = 2;  // |L + V| of a Blinn-Phong highlight; a mirrored vector needs no such care
    double arriving = 0;     // the light's intensity here: attenuation, range and cone included
};

/// A point's colour in parts: base + color * diffuse + specular, not saturated.
struct LightParts {
    glm::dvec3 base{};
    std::vector<LightShare> shares{};
    glm::dvec3 color{1};

    /// The sum, with every light's gate where N.L puts it.
    glm::dvec3 sum() const;
};

/// The same where the target is grey: light times material and the vertex colour each folded to its luma, in all channels.
LightParts in_channels(LightParts parts, Channels channels);

/// Everything at one point. Unlit materials have a base only.
LightParts light_point(const Camera& camera, shade16::View<Light> lights, const Material& material, const Pose& pose, const SurfacePoint& point);

}  // namespace shade16::reference
