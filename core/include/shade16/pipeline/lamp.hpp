// The shape of a lamp: what makes it end at a range, fall off by a power of the distance, or shine in a cone. Made once a frame,
// apart from the other lights' data, so that scenes without such lamps have none of it.
#pragma once

#include "shade16/num/scaled_power.hpp"
#include "shade16/pipeline/light_setup.hpp"

namespace shade16 {

namespace detail {
constexpr bool shapes_lamps(Needs n) { return n.falloff || n.range || n.spot; }
constexpr bool is_shaped(const Light& light) {
    return light.is_lamp() && (light.attenuation.falls_off() || light.range > Q16{} || light.kind == LightKind::spot);
}

/// How far the edges of ranges and cones are drawn in, so that rounding leaves no light outside: in units of 2^-32 of range^2; and
/// a cone's radius, the chord of its outer angle, by 2^cone_guard_log2.
inline constexpr uint32_t range_guard = 64;
inline constexpr int cone_guard_log2 = -27;
inline constexpr uint32_t range_max_error = 2 * range_guard + 4;  // of 2^-32: what the guard takes of a square, and rounding
inline constexpr uint32_t cone_max_error = 10;                   // of 2^-32, of the smoothstep

/// 1 - cos by the chord, with all its digits, Q61: a cone of 2 degrees is 6e-4 of it.
/// Range   unit vectors; 1, for everything behind.  Error  none beyond the vectors'.  Cost  a dot and three long multiplies.
/// Source  |a - b|^2 / 2 = 1 - a.b.
SHADE16_INLINE constexpr uint64_t fine_chord(const Normal30& a, const Normal30& b) {
    if (dot(a, b) <= 0) return uint64_t{1} << 61;
    const int32_t x = a.x.raw - b.x.raw, y = a.y.raw - b.y.raw, z = a.z.raw - b.z.raw;  // below sqrt(2)
    return static_cast<uint64_t>(multiply(x, x)) + static_cast<uint64_t>(multiply(y, y)) + static_cast<uint64_t>(multiply(z, z));
}
/// The same of an angle, up to 90 degrees; of the outer one a little less.
SHADE16_ONCE constexpr uint64_t opening_of(Angle angle, bool is_outer) {
    const Angle most = 90_deg;
    const uint32_t sine = magnitude(sin((most.turns < angle.turns ? most : angle).half()).raw);  // half the chord
    const uint64_t u = 4 * multiply(sine, sine), guard = uint64_t{sine} << (32 + cone_guard_log2);
    return is_outer ? u - min(guard, u) : u;
}
}  // namespace detail

/// A lamp's shape as one object sees it, for distances in units of the light's LatticePoint.
struct LampShape {
    bool falls_off = false, ends = false, is_spot = false;
    int32_t power = 0;              // of the distance, Q16
    Scaled world_squared{};         // the square of that unit in the world
    Scaled inverse_range_squared{};
    Normal30 axis{};                // towards the lamp
    uint64_t inner = 0, outer = 0;  // as fine_chord
    Scaled inverse_width{};         // 1 / (outer - inner)
    int32_t exponent = 0;           // of the cosine, Q16

    /// What arrives of a lamp at a distance squared.
    /// Range   any; nothing from the range on.  Error  range_max_error, and of a falloff that of its power.
    /// Cost    two long multiplies, and a power where it falls off.  Source  (1 - d^2/r^2)^2, and d^-p.
    template <Needs N>
    SHADE16_INLINE constexpr Scaled at_distance(Scaled squared) const {
        Scaled factor{uint32_t{1} << 31, 1};
        if (N.range && ends) {
            const uint64_t share = (squared * inverse_range_squared).to_fixed(32);
            constexpr uint64_t end = (uint64_t{1} << 32) - detail::range_guard;
            if (share >= end) return {};
            const uint32_t left = static_cast<uint32_t>(end - share);
            factor = Scaled::normalized(multiply(left, left), -64);
        }
        if (N.falloff && falls_off) factor = factor * shade16::power(squared * world_squared, -power, 17);
        return factor;
    }

    /// What arrives in the direction of a point.
    /// Range   u from 0 to 1; nothing from the outer angle on.  Error  cone_max_error, and of an exponent that of its power.
    /// Cost    four long multiplies, and a power where there is an exponent.  Source  smoothstep of the cosine, and cos^e.
    template <Needs N>
    SHADE16_INLINE constexpr Scaled in_cone(uint64_t u) const {
        if (u >= outer) return {};
        Scaled factor{uint32_t{1} << 31, 1};
        if (u > inner) {
            const uint64_t ratio = (Scaled::normalized(outer - u, -61) * inverse_width).to_fixed(32);
            const uint32_t t = static_cast<uint32_t>(min<uint64_t>(ratio, UINT32_MAX));
            factor = Scaled::normalized(multiply(t, t), -64) * Scaled::normalized((uint32_t{3} << 30) - (t >> 1), -30);
        }
        if (N.spot_exponent && exponent != 0) factor = factor * shade16::power(Scaled::normalized((uint64_t{1} << 61) - u, -61), exponent, 16);
        return factor;
    }
};

namespace detail {
/// All factors of a lamp's shape at the end of a vector that `towards` gave; zero where none of its light arrives.
/// Range   any vector.
/// Error   those of both factors; and what two rounded directions turn of a cone.
/// Cost    for a range two long multiplies, for a cone a square root with two Newton steps, for a power see scaled_power.hpp.
/// Source  the product of LampShape::at_distance and LampShape::in_cone.
template <Needs N>
SHADE16_INLINE constexpr Scaled lamp_factor(const LampShape& shape, IVec3 v, Scaled squared) {
    Scaled factor{uint32_t{1} << 31, 1};
    if constexpr (N.range || N.falloff)
        if (shape.ends || shape.falls_off) factor = shape.at_distance<N>(squared);
    if constexpr (N.spot)
        if (shape.is_spot && !factor.is_zero()) factor = factor * shape.in_cone<N>(fine_chord(normalize_finely(v), shape.axis));
    return factor;
}
}  // namespace detail

/// The shape of one lamp as one object sees it; `bits` is that of its LatticePoint.
constexpr LampShape make_lamp_shape(const Mat3& view_rotation, const Light& light, const Pose& pose, const Mesh& mesh, int bits) {
    LampShape s;
    Scaled unit = detail::scaled_scale(max(pose.scale.x, max(pose.scale.y, pose.scale.z)));
    unit.exponent = static_cast<int16_t>(unit.exponent - mesh.fraction_bits - bits);
    s.world_squared = unit * unit;
    s.power = clamp<int32_t>(light.attenuation.power.raw, 0, 2 * int32_t{65536});
    s.falls_off = s.power != 0;
    s.ends = light.range > Q16{};
    if (s.ends) {
        const Scaled range = detail::scaled_scale(light.range);
        s.inverse_range_squared = s.world_squared * reciprocal(range * range);
    }
    s.is_spot = light.kind == LightKind::spot;
    if (!s.is_spot) return s;
    const detail::LightingFrame frame(pose, mesh);
    s.axis = detail::direction_in(frame, transpose(view_rotation), light.space, -light.spot.direction);
    s.outer = detail::opening_of(light.spot.outer, true);
    s.inner = min(detail::opening_of(light.spot.inner, false), s.outer);
    s.inverse_width = reciprocal(Scaled::normalized(max(s.outer - s.inner, uint64_t{1}), -61));
    s.exponent = clamp<int32_t>(light.spot.exponent.raw, 0, 128 * int32_t{65536});
    return s;
}

}  // namespace shade16
