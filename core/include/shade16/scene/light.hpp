// Light: ambient, directional or point.
#pragma once

#include "shade16/num/scaled.hpp"
#include "shade16/num/unorm.hpp"
#include "shade16/num/vec.hpp"

namespace shade16 {

enum class LightKind : uint8_t { ambient, directional, point };

/// Where a light's position or direction is given: in the world, fixed to the camera, or riding on each object.
enum class Space : uint8_t { world, view, object };

/// How a point light fades with distance d: 1 / (constant + linear d + quadratic d^2). Negative factors count as 0.
struct Attenuation {
    Q16 constant = 1, linear = 0, quadratic = 0;
    friend constexpr bool operator==(Attenuation, Attenuation) = default;
};

struct Light {
    LightKind kind = LightKind::directional;
    Vec3 position{0, 0, 1};  // of a point light; of a directional one the direction towards it, of any length
    Rgb diffuse = white;     // of an ambient light its colour
    Rgb specular = white;
    Scaled intensity = 1;    // a factor on both colours; lamps exceed 1
    Space space = Space::world;
    Attenuation attenuation{};  // of a point light
};

constexpr Light ambient_light(Rgb color) { return {.kind = LightKind::ambient, .diffuse = color, .specular = black}; }
constexpr Light directional_light(Vec3 towards, Rgb color = white, Scaled intensity = Scaled{0x80000000u, 1}) {
    return {.kind = LightKind::directional, .position = towards, .diffuse = color, .specular = color, .intensity = intensity};
}
constexpr Light point_light(Vec3 position, Rgb color = white, Scaled intensity = Scaled{0x80000000u, 1}) {
    return {.kind = LightKind::point, .position = position, .diffuse = color, .specular = color, .intensity = intensity};
}

}  // namespace shade16
