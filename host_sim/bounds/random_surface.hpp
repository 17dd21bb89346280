// A cloud of vertices under random light: what the accuracy tests look for broken promises in. Half of the normals are
// aimed into a highlight, where the error is; uniform ones miss it.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/reference/pipeline.hpp"
#include "host_sim/report/judge.hpp"

namespace shade16::host {

class Random {
public:
    explicit Random(uint64_t seed) : engine_(seed) {}
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    bool coin() { return integer(0, 1) == 1; }
    double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    glm::dvec3 direction() {
        std::normal_distribution<double> normal;
        glm::dvec3 v;
        do v = {normal(engine_), normal(engine_), normal(engine_)};
        while (glm::length(v) < 1e-3);
        return glm::normalize(v);
    }
    Rgb color() { return {{code()}, {code()}, {code()}}; }

private:
    uint16_t code() { return static_cast<uint16_t>(integer(0, 65535)); }
    std::mt19937_64 engine_;
};

inline Q16 q16(double v) { return Q16::from_raw(static_cast<int32_t>(std::lround(v * 65536))); }
inline Vec3 vec3(const glm::dvec3& v) { return {q16(v.x), q16(v.y), q16(v.z)}; }
inline Normal14 normal14(const glm::dvec3& v) {
    const glm::dvec3 n = glm::normalize(v) * 16384.0;
    return {Unit14::from_raw(static_cast<int32_t>(std::lround(n.x))),
            Unit14::from_raw(static_cast<int32_t>(std::lround(n.y))),
            Unit14::from_raw(static_cast<int32_t>(std::lround(n.z)))};
}

/// What the search varies from case to case.
struct SurfaceOptions {
    double min_exponent = 1, max_exponent = 128;
    int lights = 1;
    bool stretch = false;
    bool attenuation = false;
    bool reflected = false;  // Phong's highlights
    bool falloff = false, range = false;
    double min_cone_degrees = 0;  // above 0: spots, with at least so much between inner and outer
    double max_distance = 400;    // of lights and eye, in model radii
};

/// One random scene of one object whose vertices have nothing to do with each other.
class RandomSurface {
public:
    static constexpr uint32_t vertex_count = 96;

    RandomSurface(Random& random, const SurfaceOptions& options) {
        choose_camera(random, options);
        choose_lights(random, options);
        choose_object(random, options);
        if (options.reflected) object_.material.reflection = Reflection::phong;
        for (Light& light : lights_) shape(random, options, light);
        scene_.lights = {lights_.data(), static_cast<uint32_t>(lights_.size())};
        scene_.objects = {&object_, 1};
        for (uint32_t i = 0; i < vertex_count; ++i) aim(random, i);
    }
    RandomSurface(const RandomSurface&) = delete;

    const Scene& scene() const { return scene_; }
    Normal14& normal(uint32_t i) { return normals_[i]; }
    Position16& position(uint32_t i) { return positions_[i]; }

    /// Gives vertex i a normal near the half vector of one light, or any.
    void aim(Random& random, uint32_t i) {
        const auto coordinate = [&] { return static_cast<int16_t>(random.integer(-32767, 32767)); };
        positions_[i] = {coordinate(), coordinate(), coordinate()};
        glm::dvec3 n = random.direction();
        if (random.coin()) {
            // A normal is aimed in the world and taken back by the transpose: the inverse of the inverse transpose.
            const glm::dvec3 half = half_vector(random, i);
            const double spread = std::sqrt(random.uniform(0, 16) / reference::value(object_.material.shininess));
            if (glm::length(half) > 1e-6) n = glm::normalize(half) + random.direction() * std::min(spread, 1.5);
            n = reference::value(object_.pose.scale) * (glm::transpose(reference::value(object_.pose.rotation)) * n);
        }
        normals_[i] = normal14(n);
    }

private:
    void choose_camera(Random& random, const SurfaceOptions& options) {
        scene_.camera.eye = vec3(random.direction() * random.log_uniform(0.5, options.max_distance));
        scene_.camera.target = vec3(random.direction());
        scene_.camera.up = vec3(random.direction());
        scene_.camera.viewer = random.coin() ? Viewer::local : Viewer::infinite;
    }
    void choose_lights(Random& random, const SurfaceOptions& options) {
        for (int i = 0; i < options.lights; ++i) {
            Light light;
            light.kind = random.coin() ? LightKind::point : LightKind::directional;
            light.space = static_cast<Space>(random.integer(0, 2));
            light.position = vec3(random.direction() * random.log_uniform(0.5, options.max_distance));
            if (options.lights > 1) {
                light.diffuse = random.color(), light.specular = random.color();
                light.intensity = Scaled::normalized(static_cast<uint64_t>(random.log_uniform(0.01, 4) * 65536), -16);
            }
            if (options.attenuation) {
                // Strong enough to arrive at about 1.0 where it stands, however far that is.
                const double d = glm::length(reference::value(light.position));
                light.attenuation = {q16(random.uniform(0, 1)), q16(random.uniform(0, 1)),
                                     q16(random.log_uniform(0.001, 1))};
                const double fading = reference::value(light.attenuation.constant) +
                                      reference::value(light.attenuation.linear) * d +
                                      reference::value(light.attenuation.quadratic) * d * d;
                light.intensity = Scaled::normalized(static_cast<uint64_t>(std::max(fading, 1e-3) * 65536), -16);
            }
            lights_.push_back(light);
        }
        if (options.lights > 1) lights_.push_back(ambient_light(random.color()));
    }
    void choose_object(Random& random, const SurfaceOptions& options) {
        Material& m = object_.material;
        m.diffuse = random.color(), m.specular = random.coin() ? white : random.color();
        m.ambient = random.color();
        if (options.lights > 1)
            m.emissive = {
                {static_cast<uint16_t>(random.integer(0, 8000))}, {static_cast<uint16_t>(random.integer(0, 8000))}, {}};
        m.shininess = q16(random.log_uniform(options.min_exponent, options.max_exponent));
        const auto angle = [&] { return Angle{static_cast<uint32_t>(random.uniform(0, 4294967295.0))}; };
        object_.pose.rotation = rotate_x(angle()) * rotate_y(angle()) * rotate_z(angle());
        object_.pose.translation = vec3(random.direction() * random.uniform(0, 1));
        const auto scale = [&] { return q16(random.log_uniform(1 / 16.0, 16)); };
        const Q16 s = scale();
        object_.pose.scale = options.stretch ? Vec3{scale(), scale(), scale()} : Vec3{s, s, s};
        object_.mesh.positions = positions_;
        object_.mesh.normals = normals_;
        object_.mesh.fraction_bits = static_cast<int8_t>(random.integer(12, 18));
    }
    /// Some point where vertices may be, in the world.
    glm::dvec3 any_point(Random& random) const {
        const double reach = std::ldexp(1.0, 15 - object_.mesh.fraction_bits);
        return reference::to_world(object_.pose, {random.uniform(-reach, reach), random.uniform(-reach, reach),
                                                  random.uniform(-reach, reach)});
    }
    /// Lamps with a falloff, a range, a cone, at whose edges there are vertices; strong enough to arrive at about 1.0.
    void shape(Random& random, const SurfaceOptions& options, Light& light) {
        const bool spot = options.min_cone_degrees > 0;
        if (light.kind == LightKind::ambient || !(options.falloff || options.range || spot)) return;
        light.kind = spot ? LightKind::spot : LightKind::point;
        const glm::dmat3 view_to_world = glm::transpose(reference::make_view(scene_.camera, {1, 1}).rotation);
        const glm::dvec3 given = reference::value(light.position), target = any_point(random);
        const glm::dvec3 place = light.space == Space::world ? given
                                 : light.space == Space::view
                                     ? reference::value(scene_.camera.eye) + view_to_world * given
                                     : reference::to_world(object_.pose, given);
        const double distance = glm::length(target - place);
        double arriving = 1;
        if (options.falloff) {
            light.attenuation.power = q16(random.uniform(0.01, 2));
            arriving *= std::pow(distance, -reference::value(light.attenuation.power));
        }
        if (options.range) {
            const double share = random.uniform(0.3, 1);
            light.range = q16(std::clamp(distance / share, 0.01, 30000.0));
            if (random.coin()) arriving *= std::max(std::pow(1 - share * share, 2), 1e-3);
        }
        light.intensity = Scaled::normalized(static_cast<uint64_t>(std::clamp(1 / arriving, 1e-3, 1e9) * 65536), -16);
        if (!spot) return;
        const double between = random.log_uniform(options.min_cone_degrees, 60);
        const double inner =
            random.coin() ? random.uniform(0, 89 - between > 0 ? 89 - between : 0) : random.uniform(0, 2);
        const auto angle = [](double degrees) {
            return Angle{static_cast<uint32_t>(std::llround(degrees / 360 * 4294967296.0))};
        };
        light.spot.inner = angle(inner), light.spot.outer = angle(inner + between);
        if (random.coin()) light.spot.exponent = q16(random.log_uniform(1, 128));
        const double off = glm::radians(random.uniform(random.coin() ? inner : 0, inner + between));
        const glm::dvec3 to_target = glm::normalize(target - place),
                         aside = glm::normalize(glm::cross(to_target, random.direction()));
        const glm::dvec3 axis = (std::cos(off) * to_target + std::sin(off) * aside) * random.log_uniform(0.1, 100);
        light.spot.direction =
            vec3(light.space == Space::world  ? axis
                 : light.space == Space::view ? glm::transpose(view_to_world) * axis
                                              : glm::transpose(reference::value(object_.pose.rotation)) * axis);
    }
    glm::dvec3 half_vector(Random& random, uint32_t i) {
        const reference::Scene exact{scene_, {reference::value(object_.mesh)}};
        const glm::dvec3 p = reference::to_world(object_.pose, exact.meshes[0].positions[i]);
        const glm::dmat3 to_world = glm::transpose(reference::make_view(scene_.camera, {1, 1}).rotation);
        const glm::dvec3 viewer =
            scene_.camera.sees_locally() ? glm::normalize(reference::value(scene_.camera.eye) - p) : to_world[2];
        const Light& light = lights_[static_cast<std::size_t>(random.integer(0, static_cast<int>(lights_.size()) - 1))];
        glm::dvec3 l = reference::value(light.position);
        if (light.space == Space::view)
            l = to_world * l + (light.is_lamp() ? reference::value(scene_.camera.eye) : glm::dvec3(0));
        if (light.space == Space::object)
            l = light.is_lamp() ? reference::to_world(object_.pose, l) : reference::value(object_.pose.rotation) * l;
        if (light.is_lamp()) l -= p;
        return glm::normalize(l) + viewer;
    }

    Position16 positions_[vertex_count]{};
    Normal14 normals_[vertex_count]{};
    std::vector<Light> lights_{};
    Object object_{};
    Scene scene_{};
};

}  // namespace shade16::host
