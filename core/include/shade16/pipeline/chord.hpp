// The chord u that highlights are computed from: between the normal and the half vector, or between the mirrored light and the
// viewer.
#pragma once

#include "shade16/num/vec.hpp"

namespace shade16::detail {

/// u from a difference of unit vectors in Q29, each component at most 2.0: the square of one is then at most 2^60, and the sum of
/// three at most 2^61.
SHADE16_INLINE constexpr uint32_t chord_of_difference(int32_t x, int32_t y, int32_t z) {
    const uint64_t squared = static_cast<uint64_t>(multiply(x, x) + multiply(y, y) + multiply(z, z));  // Q58, twice u
    return static_cast<uint32_t>(min<uint64_t>(squared >> 27, UINT32_MAX));
}

/// Of 2^-32, times sqrt(u), because differences are halved; and a unit.
inline constexpr int wide_chord_max_error = 10;

/// u = |N - H|^2 / 2 = 1 - N.H, from the chord: lengths err only relative to u, and sharp highlights stay exact.
/// Range   unit vectors; Q29 from 16-bit ones, Q32, saturated, from 32-bit ones. A stored normal longer than 1 is defined, modulo 2^32.
/// Error   none from 16-bit vectors, wide_chord_max_error from 32-bit ones.  Cost  three multiplies.
/// Source  R. F. Lyon, Phong Shading Reformulation for Hardware Renderer Simplification, 1993.
SHADE16_INLINE constexpr uint32_t chord(const Normal14& a, const Normal14& b) {
    const int32_t x = int32_t{a.x.raw} - b.x.raw, y = int32_t{a.y.raw} - b.y.raw, z = int32_t{a.z.raw} - b.z.raw;
    // Unsigned: a difference may exceed 2.0 where a stored normal is no unit vector.
    const auto squared = [](int32_t d) { return static_cast<uint32_t>(d) * static_cast<uint32_t>(d); };
    return squared(x) + squared(y) + squared(z);
}
SHADE16_INLINE constexpr uint32_t chord(const Normal30& a, const Normal30& b) {
    const auto half = [](Q30 p, Q30 q) { return static_cast<int32_t>((int64_t{p.raw} - q.raw) >> 1); };
    return chord_of_difference(half(a.x, b.x), half(a.y, b.y), half(a.z, b.z));
}

/// u = |R - V|^2 / 2 = 1 - R.V of the mirrored light R = 2(N.L)N - L, in the same units as `chord`. R - V is formed with one bit more
/// than the 16-bit vectors have.
/// Range   unit vectors; saturated, so that R.V <= 0 gives no highlight.  Error  what the tier's promise leaves for it.
/// Cost    a dot and six multiplies.  Source  Phong, Illumination for Computer Generated Pictures, 1975.
SHADE16_INLINE constexpr uint32_t reflected_chord(const Normal14& normal, const Normal14& light, const Normal14& view) {
    const int32_t cosine = shift_right_round(dot(normal, light), 13);  // Q15
    const auto squared = [cosine](Unit14 n, Unit14 l, Unit14 v) {
        const uint32_t mirrored = static_cast<uint32_t>(cosine) * static_cast<uint32_t>(int32_t{n.raw} * 2);
        const uint32_t d = mirrored - static_cast<uint32_t>((int32_t{l.raw} + v.raw) * 32768);  // R - V, Q29, at most 2.0
        const uint32_t m = min(magnitude(shift_right_round(static_cast<int32_t>(d), 14)), uint32_t{65535});
        return m * m >> 2;
    };
    return squared(normal.x, light.x, view.x) + squared(normal.y, light.y, view.y) + squared(normal.z, light.z, view.z);
}
SHADE16_INLINE constexpr uint32_t reflected_chord(const Normal30& normal, const Normal30& light, const Normal30& view) {
    const int32_t cosine = static_cast<int32_t>(shift_right_round(dot(normal, light), 30));
    const auto difference = [cosine](Q30 n, Q30 l, Q30 v) {
        return static_cast<int32_t>(shift_right_round(2 * multiply(cosine, n.raw) - ((int64_t{l.raw} + v.raw) * Q30::one), 31));
    };
    return chord_of_difference(difference(normal.x, light.x, view.x), difference(normal.y, light.y, view.y), difference(normal.z, light.z, view.z));
}

}  // namespace shade16::detail
