// sqrt inversesqrt exp2 log2 exp log pow, of scalars and by component.
#pragma once

#include "shade16/glsl/common.hpp"
#include "shade16/num/power.hpp"

namespace shade16::glsl {

inline constexpr Ulps sqrt_max_error = 0.5_ulps;
inline constexpr Ulps inversesqrt_max_error = 0.501_ulps;
inline constexpr Ulps exp2_max_error = 0.501_ulps;
inline constexpr Ulps exp_max_error = 0.501_ulps;
inline constexpr Ulps log2_max_error = 0.501_ulps;
inline constexpr Ulps log_max_error = 0.501_ulps;
inline constexpr Ulps pow_max_error = 0.68_ulps;

/// The square root.
/// Range   any; a negative number has the root 0.
/// Error   sqrt_max_error: the nearest number.  Cost  that of rounded_root.
constexpr Q16 sqrt(Q16 x) {
    return Q16::from_raw(static_cast<int32_t>(x.raw <= 0 ? 0 : rounded_root(static_cast<uint64_t>(x.raw) << 16)));
}

/// 1 / sqrt(x).
/// Range   any; 0 and negative numbers give the largest number.
/// Error   inversesqrt_max_error.  Cost  a table, two Newton steps.
SHADE16_ONCE constexpr Q16 inversesqrt(Q16 x) {
    if (x.raw <= 0) return Q16::from_raw(INT32_MAX);
    const int zeros = leading_zeros(static_cast<uint32_t>(x.raw)) & ~1;
    const uint32_t s = static_cast<uint32_t>(x.raw) << zeros;
    const uint32_t r = shade16::detail::rsqrt_step(rsqrt_newton(s), s);  // x = s 2^-(zeros + 16): 1/sqrt(x) = r 2^(zeros / 2 - 23)
    return Q16::from_raw(static_cast<int32_t>(shift_right_round(uint64_t{r}, 23 - zeros / 2)));
}

namespace detail {
/// 2^t for t in Q48, a magnitude and a sign.
/// Source  2^t = 2^(n + 1) 2^-(1 - f): num/power.hpp knows negative exponents only.
SHADE16_ONCE constexpr Q16 exp2_q48(uint64_t magnitude, bool negative) {
    constexpr uint64_t one = uint64_t{1} << 48;
    if (!negative && magnitude >= 15 * one) return Q16::from_raw(INT32_MAX);
    if (negative && magnitude >= 17 * one) return {};
    const uint64_t fraction = magnitude & (one - 1), whole = magnitude >> 48;
    const uint64_t down = negative || fraction == 0 ? fraction : one - fraction;
    const int shift = negative ? 48 + static_cast<int>(whole) : 48 - static_cast<int>(whole) - (fraction != 0);
    const uint64_t mantissa = shade16::detail::exp2_of_fraction(down);  // Q64
    const uint64_t rounded = shift > 63 ? mantissa >> 63 : shift_right_round(mantissa, shift);
    return Q16::from_raw(static_cast<int32_t>(shade16::min<uint64_t>(rounded, INT32_MAX)));
}
/// log2(x) as Q48, for x > 0: from -16 to 15.
constexpr int64_t log2_q48(Q16 x) {
    return (int64_t{16} << 48) - static_cast<int64_t>(negative_log2(static_cast<uint64_t>(x.raw) << 32));
}
constexpr Q16 q16_of_q48(int64_t x) { return Q16::from_raw(saturate(shift_right_round(x, 32))); }
}  // namespace detail

// Logarithms are made a bit at a time, and powers of two multiplied from roots of two: sure to the last bit, not quick.

/// 2^x.
/// Range   any; the largest number from x = 15, 0 from -17 down.
/// Error   exp2_max_error.  Cost  a 64-bit multiply for each bit of the fraction that is set, 16 at most.
constexpr Q16 exp2(Q16 x) { return detail::exp2_q48(uint64_t{magnitude(x.raw)} << 32, x.raw < 0); }

/// The logarithm to base 2.
/// Range   any; 0 and negative numbers give -32768.
/// Error   log2_max_error.  Cost  48 64-bit multiplies.
constexpr Q16 log2(Q16 x) { return x.raw <= 0 ? Q16::from_raw(INT32_MIN) : detail::q16_of_q48(detail::log2_q48(x)); }

/// e^x.
/// Range   any; the largest number from x = 10.4, 0 below -11.8.
/// Error   exp_max_error.  Cost  48 64-bit multiplies at most.
constexpr Q16 exp(Q16 x) {
    constexpr uint32_t log2_e = 0xB8AA3B29, log2_e_rest = 0x5C17F0BB;  // Q31, Q63
    const uint32_t m = shade16::min<uint32_t>(magnitude(x.raw), uint32_t{13} << 16);
    return detail::exp2_q48(2 * (multiply(m, log2_e) + (multiply(m, log2_e_rest) >> 32)), x.raw < 0);
}

/// The natural logarithm.
/// Range   any; 0 and negative numbers give -32768.
/// Error   log_max_error.  Cost  that of log2.
constexpr Q16 log(Q16 x) {
    if (x.raw <= 0) return Q16::from_raw(INT32_MIN);
    constexpr uint64_t ln_2 = 0xB17217F7D1CF79AB;  // Q64
    const int64_t t = detail::log2_q48(x);
    const int64_t natural = static_cast<int64_t>(mulhi(magnitude(t), ln_2));
    return detail::q16_of_q48(t < 0 ? -natural : natural);
}

/// x^y.
/// Range   any. x^0 is 1 for every x; x < 0 gives 0; 0^y is 0 for y > 0 and the largest number for y < 0.
/// Error   pow_max_error.  Cost  those of log2 and exp.
/// Source  2^(y log2 x), with 48 fraction bits between.
SHADE16_ONCE constexpr Q16 pow(Q16 x, Q16 y) {
    if (y.raw == 0) return 1;
    if (x.raw < 0) return {};
    if (x.raw == 0) return y.raw > 0 ? Q16{} : Q16::from_raw(INT32_MAX);
    const int64_t t = detail::log2_q48(x);
    return detail::exp2_q48(times_q16(magnitude(t), magnitude(y.raw)), (t < 0) != (y.raw < 0));
}

template <FloatVector A>
constexpr Value<A> sqrt(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return sqrt(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> inversesqrt(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return inversesqrt(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> exp2(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return exp2(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> log2(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return log2(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> exp(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return exp(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> log(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return log(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> pow(const A& a, const Value<A>& b) {
    return detail::each<Value<A>>([](Q16 x, Q16 y) { return pow(x, y); }, Value<A>(a), b);
}

}  // namespace shade16::glsl
