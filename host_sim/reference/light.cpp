#include "host_sim/reference/light.hpp"

#include <algorithm>
#include <cmath>

namespace shade16::reference {

namespace {
glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length == 0 ? glm::dvec3(0) : v / length;
}

/// The vector from the point to the light; of a directional light only its direction counts.
glm::dvec3 vector_to_light(const Camera& camera, const glm::dmat3& view_to_world, const Light& light, const Pose& pose, const glm::dvec3& position) {
    const glm::dvec3 given = value(light.position);
    if (light.kind == LightKind::directional) {
        if (light.space == Space::world) return given;
        return (light.space == Space::view ? view_to_world : value(pose.rotation)) * given;
    }
    if (light.space == Space::world) return given - position;
    if (light.space == Space::view) return value(camera.eye) + view_to_world * given - position;
    return to_world(pose, given) - position;
}

/// 1 / (constant + linear d + quadratic d^2) of a point light; negative factors count as 0.
double attenuation(const Light& light, double distance) {
    if (light.kind != LightKind::point) return 1;
    const auto factor = [](Q16 v) { return std::max(value(v), 0.0); };
    const Attenuation& a = light.attenuation;
    return 1 / (factor(a.constant) + factor(a.linear) * distance + factor(a.quadratic) * distance * distance);
}

LightShare share_of(const Light& light, const Material& material, const SurfacePoint& point, const glm::dvec3& towards_light, const glm::dvec3& to_viewer) {
    const glm::dvec3 to_light = unit(towards_light);
    LightShare share;
    const double exponent = std::clamp(value(material.shininess), 1.0, 1000.0);
    const glm::dvec3 half = to_light + to_viewer;
    const double n_dot_h = glm::dot(point.normal, unit(half));
    share.n_dot_l = glm::dot(point.normal, to_light);
    share.half_length = glm::length(half);
    share.arriving = value(light.intensity) * attenuation(light, glm::length(towards_light));
    share.diffuse = value(material.diffuse) * value(light.diffuse) * share.arriving * std::max(share.n_dot_l, 0.0);
    if (n_dot_h > 0) share.specular = value(material.specular) * value(light.specular) * share.arriving * std::pow(std::min(n_dot_h, 1.0), exponent);
    return share;
}
}  // namespace

glm::dvec3 LightParts::sum() const {
    glm::dvec3 diffuse = base, specular(0);
    for (const LightShare& share : shares) {
        diffuse += share.diffuse;
        if (share.n_dot_l > 0) specular += share.specular;
    }
    return color * diffuse + specular;
}

LightParts light_point(const Camera& camera, shade16::View<Light> lights, const Material& material, const Pose& pose, const SurfacePoint& point) {
    LightParts parts;
    parts.color = point.color;
    if (material.unlit) {
        parts.base = value(material.diffuse);
        return parts;
    }
    const glm::dmat3 view_to_world = glm::transpose(reference::make_view(camera, {1, 1}).rotation);
    const glm::dvec3 to_viewer = camera.sees_locally() ? unit(value(camera.eye) - point.position) : view_to_world[2];
    parts.base = value(material.emissive);
    for (const Light& light : lights) {
        if (light.kind == LightKind::ambient)
            parts.base += value(material.ambient_color()) * value(light.diffuse) * value(light.intensity);
        else
            parts.shares.push_back(share_of(light, material, point, vector_to_light(camera, view_to_world, light, pose, point.position), to_viewer));
    }
    return parts;
}

}  // namespace shade16::reference
