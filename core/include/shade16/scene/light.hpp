// Light: ambient, directional, point or spot.
#pragma once

#include "shade16/num/angle.hpp"
#include "shade16/num/scaled.hpp"
#include "shade16/num/unorm.hpp"
#include "shade16/num/vec.hpp"

namespace shade16 {

enum class LightKind : uint8_t { ambient, directional, point, spot };

/// Where a light's position or direction is given: in the world, fixed to the camera, or riding on each object.
enum class Space : uint8_t { world, view, object };

/// How a lamp fades with distance d: 1 / (constant + linear d + quadratic d^2), times 1 / d^power. Negative factors count as 0; the
/// power is clamped to [0, 2].
struct Attenuation {
    Q16 constant = 1, linear = 0, quadratic = 0, power = 0;

    constexpr bool fades() const { return constant != Q16{1} || linear != Q16{} || quadratic != Q16{}; }
    constexpr bool falls_off() const { return power > Q16{}; }
    friend constexpr bool operator==(Attenuation, Attenuation) = default;
};

/// The cone of a spot, which stands at the light's position. Angles are from its axis: full light inside `inner`, none outside
/// `outer`, and between them smoothstep(cos outer, cos inner, cos angle), t^2 (3 - 2t). All of it times cos^exponent, OpenGL's
/// GL_SPOT_EXPONENT. `outer` is clamped to 90 degrees, `inner` to `outer` (a hard edge), the exponent to [0, 128].
struct Spot {
    Vec3 direction{0, 0, -1};  // where it shines to, of any length, in the light's space
    Angle inner{}, outer = 45_deg;
    Q16 exponent = 0;
    friend constexpr bool operator==(const Spot&, const Spot&) = default;
};

struct Light {
    LightKind kind = LightKind::directional;
    Vec3 position{0, 0, 1};  // of a point light or a spot; of a directional one the direction towards it, of any length
    Rgb diffuse = white;     // of an ambient light its colour
    Rgb specular = white;
    Scaled intensity = 1;    // a factor on both colours; lamps exceed 1
    Space space = Space::world;
    Attenuation attenuation{};  // of a point light or a spot, as are range and spot below
    Q16 range = 0;  // above 0: a factor (1 - d^2 / range^2)^2, and exactly nothing from this distance on
    Spot spot{};

    constexpr bool is_lamp() const { return kind == LightKind::point || kind == LightKind::spot; }
};

constexpr Light ambient_light(Rgb color) { return {.kind = LightKind::ambient, .diffuse = color, .specular = black}; }
constexpr Light directional_light(Vec3 towards, Rgb color = white, Scaled intensity = Scaled{0x80000000u, 1}) {
    return {.kind = LightKind::directional, .position = towards, .diffuse = color, .specular = color, .intensity = intensity};
}
constexpr Light point_light(Vec3 position, Rgb color = white, Scaled intensity = Scaled{0x80000000u, 1}) {
    return {.kind = LightKind::point, .position = position, .diffuse = color, .specular = color, .intensity = intensity};
}
constexpr Light spot_light(Vec3 position, const Spot& spot, Rgb color = white, Scaled intensity = Scaled{0x80000000u, 1}) {
    return {.kind = LightKind::spot, .position = position, .diffuse = color, .specular = color, .intensity = intensity, .spot = spot};
}

}  // namespace shade16
