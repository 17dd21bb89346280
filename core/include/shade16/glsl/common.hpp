// abs sign floor ceil trunc fract mod min max clamp mix step smoothstep, and divide, which GLSL writes as a / b.
#pragma once

#include "shade16/glsl/operators.hpp"
#include "shade16/num/rounded.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16::glsl {

// Exact for every number, and of a few instructions: abs .. fract, min, max, clamp, step. What does not fit is the nearest
// number: abs(-32768), ceil(32767.5).

constexpr Q16 abs(Q16 x) { return x.raw < 0 ? -x : x; }
constexpr Q16 sign(Q16 x) { return Q16::from_int((x.raw > 0) - (x.raw < 0)); }
constexpr Q16 floor(Q16 x) { return Q16::from_raw(static_cast<int32_t>(static_cast<uint32_t>(x.raw) & 0xFFFF0000u)); }
constexpr Q16 ceil(Q16 x) { return floor(x) == x ? x : floor(x) + 1; }
constexpr Q16 trunc(Q16 x) { return x.raw < 0 ? ceil(x) : floor(x); }
/// x - floor(x), in [0, 1).
constexpr Q16 fract(Q16 x) { return Q16::from_raw(x.raw & 0xFFFF); }
constexpr Q16 min(Q16 a, Q16 b) { return b < a ? b : a; }
constexpr Q16 max(Q16 a, Q16 b) { return a < b ? b : a; }
/// min(max(x, low), high), also for low > high.
constexpr Q16 clamp(Q16 x, Q16 low, Q16 high) { return min(max(x, low), high); }
/// 0 for x < edge, else 1.
constexpr Q16 step(Q16 edge, Q16 x) { return Q16::from_int(x < edge ? 0 : 1); }

/// x - y floor(x / y): the sign is that of y.
/// Range   any; y = 0 gives 0.  Error  none.  Cost  a quotient.
SHADE16_ONCE constexpr Q16 mod(Q16 x, Q16 y) {
    const uint32_t modulus = magnitude(y.raw);
    if (modulus == 0) return {};
    const uint32_t whole = static_cast<uint32_t>(floor_quotient(x.raw, modulus)) * modulus;  // modulo 2^32, as the next line
    const uint32_t rest = static_cast<uint32_t>(x.raw) - whole;
    return Q16::from_raw(y.raw > 0 || rest == 0 ? static_cast<int32_t>(rest) : -static_cast<int32_t>(modulus - rest));
}

inline constexpr Ulps divide_max_error = 0.5_ulps;

/// a / b, the name for what has no operator: it costs a reciprocal and its remainder.
/// Range   any; what does not fit, and a / 0, is the largest number of its sign; 0 / 0 is 0.
/// Error   divide_max_error: the nearest number.
SHADE16_ONCE constexpr Q16 divide(Q16 a, Q16 b) {
    if (a.raw == 0) return {};
    const bool negative = (a.raw < 0) != (b.raw < 0);
    const uint64_t n = uint64_t{magnitude(a.raw)} << 16;
    const uint32_t d = magnitude(b.raw);
    const int64_t q = (n >> 31) >= d ? int64_t{1} << 31 : rounded_quotient(n, d);
    return Q16::from_raw(saturate(negative ? -q : q));
}

inline constexpr Ulps mix_max_error = 0.501_ulps;

/// a (1 - t) + b t, for any t; exactly a at 0 and b at 1.
/// Range   any; saturates.  Error  mix_max_error.  Cost  two long multiplies.
constexpr Q16 mix(Q16 a, Q16 b, Q16 t) {
    const int64_t half = (multiply(b.raw, t.raw) >> 1) - (multiply(a.raw, t.raw) >> 1) + int64_t{a.raw} * 32768;
    return Q16::from_raw(saturate(shift_right_round(half, 15)));
}
constexpr Q16 mix(Q16 a, Q16 b, bool t) { return t ? b : a; }

inline constexpr Ulps smoothstep_max_error = 0.501_ulps;

/// t t (3 - 2 t) for t = (x - low) / (high - low) clamped to [0, 1].
/// Range   any; low > high falls instead of rising, low = high is a step.
/// Error   smoothstep_max_error.  Cost  a rounded quotient and three multiplies.
SHADE16_ONCE constexpr Q16 smoothstep(Q16 low, Q16 high, Q16 x) {
    const bool falls = high < low;
    int64_t d = int64_t{high.raw} - low.raw, n = int64_t{x.raw} - low.raw;
    if (falls) d = -d, n = -n;
    if (n >= d) return 1;
    if (n <= 0) return {};
    const uint32_t t = rounded_quotient(static_cast<uint64_t>(n) << 30, static_cast<uint32_t>(d));
    const uint32_t tt = static_cast<uint32_t>(multiply(t, t) >> 30);
    const uint64_t smooth = multiply(tt, (uint32_t{3} << 30) - 2 * t);  // Q60
    return Q16::from_raw(static_cast<int32_t>(shift_right_round(smooth, 44)));
}

// The same by component.
template <FloatVector A>
constexpr Value<A> abs(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return abs(x); }, Value<A>(a));
}
template <IntVector A>
constexpr Value<A> abs(const A& a) {
    return detail::each<Value<A>>([](int32_t x) { return x < 0 ? detail::subtract(0, x) : x; }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> sign(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return sign(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> floor(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return floor(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> ceil(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return ceil(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> trunc(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return trunc(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> fract(const A& a) {
    return detail::each<Value<A>>([](Q16 x) { return fract(x); }, Value<A>(a));
}
template <FloatVector A>
constexpr Value<A> mod(const A& a, const Value<A>& b) {
    return detail::each<Value<A>>([](Q16 x, Q16 y) { return mod(x, y); }, Value<A>(a), b);
}
template <FloatVector A>
constexpr Value<A> mod(const A& a, Q16 b) { return mod(a, Value<A>(b)); }
template <FloatVector A>
constexpr Value<A> divide(const A& a, const Value<A>& b) {
    return detail::each<Value<A>>([](Q16 x, Q16 y) { return divide(x, y); }, Value<A>(a), b);
}
template <FloatVector A>
constexpr Value<A> divide(const A& a, Q16 b) { return divide(a, Value<A>(b)); }
template <NumberVector A>
constexpr Value<A> min(const A& a, const Value<A>& b) {
    return detail::each<Value<A>>([](auto x, auto y) { return y < x ? y : x; }, Value<A>(a), b);
}
template <NumberVector A>
constexpr Value<A> min(const A& a, Scalar<A> b) { return min(a, Value<A>(b)); }
template <NumberVector A>
constexpr Value<A> max(const A& a, const Value<A>& b) {
    return detail::each<Value<A>>([](auto x, auto y) { return x < y ? y : x; }, Value<A>(a), b);
}
template <NumberVector A>
constexpr Value<A> max(const A& a, Scalar<A> b) { return max(a, Value<A>(b)); }
template <NumberVector A>
constexpr Value<A> clamp(const A& a, const Value<A>& low, const Value<A>& high) { return min(max(a, low), high); }
template <NumberVector A>
constexpr Value<A> clamp(const A& a, Scalar<A> low, Scalar<A> high) { return min(max(a, low), high); }
template <FloatVector A>
constexpr Value<A> mix(const A& a, const Value<A>& b, const Value<A>& t) {
    return detail::each<Value<A>>([](Q16 x, Q16 y, Q16 s) { return mix(x, y, s); }, Value<A>(a), b, t);
}
template <FloatVector A>
constexpr Value<A> mix(const A& a, const Value<A>& b, Q16 t) { return mix(a, b, Value<A>(t)); }
template <FloatVector A>
constexpr Value<A> mix(const A& a, const Value<A>& b, const Vector<bool, A::size>& t) {
    return detail::each<Value<A>>([](Q16 x, Q16 y, bool s) { return s ? y : x; }, Value<A>(a), b, t);
}
template <FloatVector A>
constexpr Value<A> step(const A& edge, const Value<A>& x) {
    return detail::each<Value<A>>([](Q16 e, Q16 p) { return step(e, p); }, Value<A>(edge), x);
}
template <FloatVector A>
constexpr Value<A> step(Q16 edge, const A& x) { return step(Value<A>(edge), x); }
template <FloatVector A>
constexpr Value<A> smoothstep(const A& low, const Value<A>& high, const Value<A>& x) {
    return detail::each<Value<A>>([](Q16 l, Q16 h, Q16 p) { return smoothstep(l, h, p); }, Value<A>(low), high, x);
}
template <FloatVector A>
constexpr Value<A> smoothstep(Q16 low, Q16 high, const A& x) { return smoothstep(Value<A>(low), Value<A>(high), x); }

}  // namespace shade16::glsl
