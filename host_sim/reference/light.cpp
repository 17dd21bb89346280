#include "host_sim/reference/light.hpp"

#include <algorithm>
#include <cmath>

namespace shade16::reference {

namespace {
glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length == 0 ? glm::dvec3(0) : v / length;
}

/// A direction of a light's space in the world.
glm::dvec3 direction_in(const glm::dmat3& view_to_world, Space space, const Pose& pose, const glm::dvec3& given) {
    if (space == Space::world) return given;
    return (space == Space::view ? view_to_world : value(pose.rotation)) * given;
}

/// The vector from the point to the light; of a directional light only its direction counts.
glm::dvec3 vector_to_light(const Camera& camera, const glm::dmat3& view_to_world, const Light& light, const Pose& pose, const glm::dvec3& position) {
    const glm::dvec3 given = value(light.position);
    if (light.kind == LightKind::directional) return direction_in(view_to_world, light.space, pose, given);
    if (light.space == Space::world) return given - position;
    if (light.space == Space::view) return value(camera.eye) + view_to_world * given - position;
    return to_world(pose, given) - position;
}

/// 1 / (constant + linear d + quadratic d^2) / d^power of a lamp; negative factors count as 0.
double attenuation(const Light& light, double distance) {
    const auto factor = [](Q16 v) { return std::max(value(v), 0.0); };
    const Attenuation& a = light.attenuation;
    const double power = std::clamp(value(a.power), 0.0, 2.0);
    return std::pow(distance, -power) / (factor(a.constant) + factor(a.linear) * distance + factor(a.quadratic) * distance * distance);
}

/// (1 - d^2 / range^2)^2 inside the range, nothing outside.
double range_window(const Light& light, double distance) {
    if (value(light.range) <= 0) return 1;
    const double left = std::max(1 - distance * distance / (value(light.range) * value(light.range)), 0.0);
    return left * left;
}

/// smoothstep(cos outer, cos inner, cos) cos^exponent of the angle between a spot's axis and the way to a point.
double cone(const Spot& spot, const glm::dvec3& axis, const glm::dvec3& from_light) {
    const double right_angle = radians(90_deg);
    const double outer_angle = std::min(radians(spot.outer), right_angle), inner_angle = std::min(radians(spot.inner), outer_angle);
    // 1 - cos, by the chord: a double has too few digits of a cosine near 1 to be subtracted from another.
    const auto opening = [](double angle) { return 2 * std::pow(std::sin(angle / 2), 2); };
    const double u = std::pow(glm::length(unit(axis) - unit(from_light)), 2) / 2, outer = opening(outer_angle), inner = opening(inner_angle);
    if (u >= outer) return 0;
    const double t = u <= inner ? 1 : (outer - u) / (outer - inner);
    return t * t * (3 - 2 * t) * std::pow(1 - u, std::clamp(value(spot.exponent), 0.0, 128.0));
}

/// The cosine whose power the highlight is: N.H, or R.V of the mirrored light.
double highlight_cosine(const Material& material, const glm::dvec3& normal, const glm::dvec3& to_light, const glm::dvec3& to_viewer) {
    if (material.reflection == Reflection::blinn_phong) return glm::dot(normal, unit(to_light + to_viewer));
    return glm::dot(2 * glm::dot(normal, to_light) * normal - to_light, to_viewer);
}

LightShare share_of(const Light& light, const Material& material, const SurfacePoint& point, const glm::dvec3& towards_light,
                    const glm::dvec3& spot_axis, const glm::dvec3& to_viewer) {
    const glm::dvec3 to_light = unit(towards_light);
    LightShare share;
    const double exponent = std::clamp(value(material.shininess), 1.0, 1000.0);
    const double cosine = highlight_cosine(material, point.normal, to_light, to_viewer);
    share.n_dot_l = glm::dot(point.normal, to_light);
    if (material.reflection == Reflection::blinn_phong) share.half_length = glm::length(to_light + to_viewer);
    share.arriving = value(light.intensity);
    if (light.is_lamp()) {
        const double distance = glm::length(towards_light);
        share.arriving *= attenuation(light, distance) * range_window(light, distance);
    }
    if (light.kind == LightKind::spot) share.arriving *= cone(light.spot, spot_axis, -towards_light);
    share.diffuse = value(material.diffuse) * value(light.diffuse) * share.arriving * std::max(share.n_dot_l, 0.0);
    if (cosine > 0) share.specular = value(material.specular) * value(light.specular) * share.arriving * std::pow(std::min(cosine, 1.0), exponent);
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

LightParts in_channels(LightParts parts, Channels channels) {
    if (channels == Channels::rgb) return parts;
    for (LightShare& share : parts.shares) share.diffuse = luma(share.diffuse), share.specular = luma(share.specular);
    parts.base = luma(parts.base), parts.color = luma(parts.color);
    return parts;
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
            parts.shares.push_back(share_of(light, material, point, vector_to_light(camera, view_to_world, light, pose, point.position),
                                            direction_in(view_to_world, light.space, pose, value(light.spot.direction)), to_viewer));
    }
    return parts;
}

}  // namespace shade16::reference
