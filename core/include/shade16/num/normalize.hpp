// normalize: a vector of any magnitude to a unit vector, by a block-floating shift. The shift changes no direction, so
// the smallest and the largest vector are as accurate as any other.
#pragma once

#include "shade16/num/rsqrt.hpp"
#include "shade16/num/ulps.hpp"
#include "shade16/num/vec.hpp"

namespace shade16 {

namespace detail {
/// The vector scaled so that its largest magnitude has its top bit at `bit`; rounded when that loses bits.
SHADE16_INLINE constexpr IVec3 with_top_bit_at(IVec3 v, uint32_t magnitudes, int bit) {
    const int shift = leading_zeros(magnitudes) - (31 - bit);
    if (shift >= 0) return {shift_left(v.x, shift), shift_left(v.y, shift), shift_left(v.z, shift)};
    return {shift_right_round(v.x, -shift), shift_right_round(v.y, -shift), shift_right_round(v.z, -shift)};
}
SHADE16_INLINE constexpr uint32_t magnitudes(IVec3 v) { return magnitude(v.x) | magnitude(v.y) | magnitude(v.z); }
}  // namespace detail

/// Errors of a component: of Unit14 with the table of 97 and with that of 49, and of Q30.
inline constexpr Ulps normalize14_max_error = 1.76_ulps, normalize14_small_max_error = 3.75_ulps, normalize30_max_error = 62_ulps;
/// Of the direction: a component is rounded when it is shifted and when it is multiplied, sqrt(3) (0.5 + 0.5), in 32 bits
/// sqrt(3) (1 + 0.5); the length's error does not turn the vector.
inline constexpr Ulps normalize14_max_angle = 1.733_ulps, normalize30_max_angle = 2.599_ulps;

/// v / |v| in 16 bits.
/// Range   any v; a zero vector gives a zero vector.
/// Error   normalize14_max_error with Bits = 7, normalize14_small_max_error with Bits = 6.
/// Cost    M0+ 171, M3 89 cycles (prototype figures).
/// Source  block-floating shift, then x / sqrt(x.x).
template <int Bits>
SHADE16_ONCE constexpr Normal14 normalize14(IVec3 v) {
    const uint32_t m = detail::magnitudes(v);
    if (m == 0) return {};
    v = detail::with_top_bit_at(v, m, 14);
    uint32_t s = static_cast<uint32_t>(v.x * v.x) + static_cast<uint32_t>(v.y * v.y) + static_cast<uint32_t>(v.z * v.z);
    int shift = 17;
    if (s < (uint32_t{1} << 30)) {
        s <<= 2;
        shift = 16;
    }
    const int32_t r = static_cast<int32_t>(rsqrt_linear<Bits>(s));
    const int32_t half = int32_t{1} << (shift - 1);
    const auto component = [=](int32_t c) { return Unit14{static_cast<int16_t>((c * r + half) >> shift)}; };
    return {component(v.x), component(v.y), component(v.z)};
}

namespace detail {
/// v / |v| in 32 bits, by `Steps` Newton steps.
template <int Steps>
SHADE16_ONCE constexpr Normal30 normalize_wide(IVec3 v) {
    const uint32_t m = magnitudes(v);
    if (m == 0) return {};
    v = with_top_bit_at(v, m, 29);
    const uint64_t s = static_cast<uint64_t>(multiply(v.x, v.x)) + static_cast<uint64_t>(multiply(v.y, v.y)) +
                       static_cast<uint64_t>(multiply(v.z, v.z));
    const bool large = (s >> 60) != 0;
    const uint32_t mantissa = static_cast<uint32_t>(large ? s >> 30 : s >> 28);
    uint32_t r = rsqrt_newton(mantissa);
    if constexpr (Steps == 2) r = rsqrt_step(r, mantissa);
    const int shift = large ? 32 : 31;
    const auto component = [=](int32_t c) { return Q30::from_raw(shift_right_round(multiply(c, r), shift)); };
    return {component(v.x), component(v.y), component(v.z)};
}

}  // namespace detail

/// v / |v| in 32 bits.
/// Range   any v; a zero vector gives a zero vector.
/// Error   normalize30_max_error.
/// Cost    M0+ 366, M3 137 cycles (prototype figures).
/// Source  as normalize14, in 64 bits, with rsqrt_newton.
constexpr Normal30 normalize30(IVec3 v) { return detail::normalize_wide<1>(v); }

inline constexpr Ulps normalize_finely_max_error = 2_ulps;  // of Q30, a component

/// The same with one more Newton step, for what is made once a frame and scaled up by distances: cameras, directions.
/// Range   any v; a zero vector gives a zero vector.
/// Error   normalize_finely_max_error.  Cost  that of normalize30 and three high words.  Source  two Newton steps.
constexpr Normal30 normalize_finely(IVec3 v) { return detail::normalize_wide<2>(v); }

/// v / |v| of a Q16 vector, as a user calls it.  Range  any.  Error  normalize_finely_max_error.  Cost, Source  normalize_finely.
constexpr Normal30 normalize(Vec3 v) { return normalize_finely(raw(v)); }

}  // namespace shade16
