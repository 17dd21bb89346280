// radians degrees sin cos tan asin acos atan, of scalars and by component. Angles are radians, as in GLSL; where a program
// may choose, the core's Angle (num/angle.hpp) is quicker and wraps without loss.
#pragma once

#include "shade16/glsl/operators.hpp"
#include "shade16/num/arc.hpp"
#include "shade16/num/rounded.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16::glsl {

inline constexpr Ulps radians_max_error = 0.501_ulps;
inline constexpr Ulps degrees_max_error = 0.501_ulps;
inline constexpr Ulps sin_max_error = 0.501_ulps;
inline constexpr Ulps cos_max_error = 0.501_ulps;
inline constexpr Ulps tan_max_error = 0.62_ulps;         // where |tan x| < 256
inline constexpr int tan_max_relative_error_log2 = -30;  // and this share of |tan x| beside it where it is more
inline constexpr Ulps asin_max_error = 0.501_ulps;
inline constexpr Ulps acos_max_error = 0.501_ulps;
inline constexpr Ulps atan_max_error = 0.501_ulps;

namespace detail {
/// x * (factor + rest * 2^-32) / 2^shift, rounded and saturated.
constexpr Q16 times_constant(Q16 x, uint32_t factor, uint32_t rest, int shift) {
    return Q16::from_raw(saturate(shift_right_round(multiply(x.raw, factor) + (multiply(x.raw, rest) >> 32), shift)));
}

/// Turns with 64 fraction bits, modulo 1.
/// Error   2^-64 turn, for all of [-32768, 32768) radians.
constexpr uint64_t turns(Q16 radians) {
    constexpr uint64_t factor = 0x28BE60DB9391;   // 2^48 / 2 pi
    constexpr uint32_t rest = 0x054A7F09;         // and its next 32 bits
    return static_cast<uint64_t>(int64_t{radians.raw}) * factor + static_cast<uint64_t>(multiply(radians.raw, rest) >> 32);
}
constexpr Angle angle(Q16 radians) { return {static_cast<uint32_t>((turns(radians) + (uint64_t{1} << 31)) >> 32)}; }

/// An angle of at most half a turn in radians.
constexpr Q16 radians_of(Angle a) {
    constexpr uint32_t two_pi = 0xC90FDAA2;  // Q29
    return Q16::from_raw(static_cast<int32_t>(shift_right_round(multiply(a.turns, two_pi), 45)));
}
/// sin(x)/x or cos(x) as Q31, by the divisors of num/angle.hpp, for xx = x^2 as Q32.
SHADE16_ONCE constexpr uint32_t series(uint32_t xx, const uint32_t (&reciprocals)[5]) {
    uint32_t sum = uint32_t{1} << 31;
    for (const uint32_t reciprocal : reciprocals) sum = shade16::detail::taylor_factor(xx, reciprocal, sum);
    return sum;
}
constexpr Q16 q16(Q30 x) { return Q16::from_raw(shift_right_round(x.raw, 14)); }
}  // namespace detail

/// Degrees to radians, and back.
/// Range   any; degrees saturates beyond 571.9 radians.
/// Error   radians_max_error, degrees_max_error.
constexpr Q16 radians(Q16 degrees) { return detail::times_constant(degrees, 0x8EFA3512, 0x94E9C8AE, 37); }
constexpr Q16 degrees(Q16 radians) { return detail::times_constant(radians, 0xE52EE0D3, 0x1E0FBDC3, 26); }

/// Sine and cosine.
/// Range   any: an angle of 32767 radians is reduced as exactly as one of 1.
/// Error   sin_max_error, cos_max_error.  Cost  that of sincos and four long multiplies.
constexpr Q16 sin(Q16 x) { return detail::q16(shade16::sin(detail::angle(x))); }
constexpr Q16 cos(Q16 x) { return detail::q16(shade16::cos(detail::angle(x))); }

/// sin x / cos x.
/// Range   any; saturates beside the poles.
/// Error   tan_max_error; from |tan x| = 256 also 2^tan_max_relative_error_log2 of it: two units at the most.
/// Cost    the series of sine and cosine, and a quotient.
SHADE16_ONCE constexpr Q16 tan(Q16 x) {
    const uint64_t t = detail::turns(x), quarter = (t + (uint64_t{1} << 61)) >> 62;
    const int64_t rest = static_cast<int64_t>(t - (quarter << 62));  // within an eighth of a turn of a zero or a pole
    const Scaled radians = Scaled::normalized(magnitude(rest), -64) * Scaled(0xC90FDAA2, 3);
    const uint32_t fixed = static_cast<uint32_t>(radians.to_fixed(32)), xx = mulhi(fixed, fixed);
    const Scaled sine = radians * Scaled::normalized(detail::series(xx, shade16::detail::sine_reciprocals), -31);
    const Scaled cosine = Scaled::normalized(detail::series(xx, shade16::detail::cosine_reciprocals), -31);
    const bool odd = quarter & 1;
    const Scaled n = odd ? cosine : sine, d = odd ? sine : cosine;
    const uint32_t ratio = rounded_quotient(uint64_t{n.mantissa} << 31, d.mantissa);
    const int64_t signed_ratio = (rest < 0) != odd ? -int64_t{ratio} : int64_t{ratio};
    return Q16::from_raw(scale_by_power_of_two(signed_ratio, n.exponent - d.exponent - 15));
}

namespace detail {
/// sqrt(1 - x^2) as Q30, for |x| <= 1 in Q16.
constexpr Q30 other_side(uint32_t x) { return {static_cast<int32_t>(rounded_root(((uint64_t{1} << 32) - multiply(x, x)) << 28))}; }
constexpr Q16 with_sign_of(int32_t sign, Q16 x) { return sign < 0 ? -x : x; }
}  // namespace detail

/// The angle in [-pi/2, pi/2] with sine x, and the one in [0, pi] with cosine x.
/// Range   any; what lies outside [-1, 1] counts as its nearest end.
/// Error   asin_max_error, acos_max_error.  Cost  a root, a reciprocal, a sine and a cosine.
SHADE16_ONCE constexpr Q16 asin(Q16 x) {
    const uint32_t side = shade16::min<uint32_t>(magnitude(x.raw), 65536);
    return detail::with_sign_of(x.raw, detail::radians_of(arctangent(Q30{static_cast<int32_t>(side << 14)}, detail::other_side(side))));
}
SHADE16_ONCE constexpr Q16 acos(Q16 x) {
    const int32_t side = shade16::clamp<int32_t>(x.raw, -65536, 65536);
    return detail::radians_of(arctangent(detail::other_side(magnitude(side)), Q30{shift_left(side, 14)}));
}

/// The angle of the vector (x, y), in (-pi, pi], with GLSL's order of arguments; and the one in [-pi/2, pi/2] with tangent x.
/// Range   any; atan(0, 0) is 0.
/// Error   atan_max_error.  Cost  normalize, a reciprocal, a sine and a cosine.
SHADE16_ONCE constexpr Q16 atan(Q16 y, Q16 x) {
    const Normal30 unit = normalize_finely({x.raw, y.raw, 0});
    const Q30 up{static_cast<int32_t>(magnitude(unit.y.raw))};
    return detail::with_sign_of(y.raw, detail::radians_of(arctangent(up, unit.x)));
}
constexpr Q16 atan(Q16 x) { return atan(x, 1); }

template <FloatVector A>
constexpr Value<A> radians(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return radians(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> degrees(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return degrees(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> sin(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return sin(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> cos(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return cos(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> tan(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return tan(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> asin(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return asin(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> acos(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return acos(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> atan(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return atan(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> atan(const A& y, const Value<A>& x) {
    return detail::each<Value<A>>([](Q16 p, Q16 q) { return atan(p, q); }, Value<A>(y), x);
}

}  // namespace shade16::glsl
