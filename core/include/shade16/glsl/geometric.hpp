// length distance normalize cross reflect refract faceforward; dot is beside the matrices. All hold over the full range:
// vectors of one unit and of -32768 are as good as any other.
#pragma once

#include "shade16/glsl/exponential.hpp"
#include "shade16/glsl/matrix.hpp"
#include "shade16/num/normalize.hpp"

namespace shade16::glsl {

inline constexpr Ulps length_max_error = 0.5_ulps;
inline constexpr Ulps normalize_max_error = 0.501_ulps;
inline constexpr Ulps cross_max_error = 0.501_ulps;
inline constexpr Ulps reflect_max_error = 0.501_ulps;
inline constexpr int reflect_max_relative_error_log2 = -30;  // of 2 |n.i|, beside it where that is 16 or more
inline constexpr Ulps refract_max_error = 0.501_ulps;

namespace detail {
/// The sum of the components' squares, Q32; 2^63 when it is more.
template <FloatVector A>
constexpr uint64_t square(const A& a) {
    const Value<A> v = a;
    constexpr uint64_t limit = uint64_t{1} << 63;
    const auto squared = [](Q16 x) { return multiply(magnitude(x.raw), magnitude(x.raw)); };
    if constexpr (A::size < 4) return shade16::min<uint64_t>(sum_of(squared, v), limit);  // 3 * 2^62
    else return shade16::min<uint64_t>(shade16::min<uint64_t>(sum_of(squared, Vector<Q16, 3>(v)), limit) + squared(v.w), limit);
}

/// a.b with 32 fraction bits, exactly where it is below 2^29.
template <class V>
constexpr int64_t dot_q32(const V& a, const V& b) {
    const int64_t quarters = sum_of([](Q16 p, Q16 q) { return multiply(p.raw, q.raw) >> 2; }, a, b);
    const int64_t rest = sum_of([](Q16 p, Q16 q) { return multiply(p.raw, q.raw) & 3; }, a, b);
    constexpr int64_t limit = int64_t{1} << 59;
    return shade16::clamp<int64_t>(quarters, -limit, limit) * 4 + rest;
}

/// A factor in Q32 of which the first 31 bits count: mantissa * 2^(shift - 32).
struct Factor {
    int32_t mantissa = 0;
    int shift = 0;

    constexpr explicit Factor(int64_t k) : shift(shade16::max<int>(33 - leading_zeros(magnitude(k)), 0)) { mantissa = saturate(shift_right_round(k, shift)); }
};

/// base - k n for a base in Q32.
SHADE16_ONCE constexpr Q16 less_multiple(int64_t base, Factor k, Q16 n) {
    const int64_t product = multiply(k.mantissa, n.raw);  // with 48 - shift fraction bits
    const int up = k.shift - 16;
    if (up <= 0) return Q16::from_raw(saturate(shift_right_round(base - shift_right_round(product, -up), 16)));
    const int64_t limit = (int64_t{1} << 61) >> up;
    const int64_t multiple = shade16::clamp<int64_t>(product, -limit, limit) * (int64_t{1} << up);
    return Q16::from_raw(saturate(shift_right_round(base - multiple, 16)));
}

/// sqrt(1 - eta^2 (1 - d^2)) as Q31 for d in Q32; false where there is no root.
SHADE16_ONCE constexpr bool refracted_cosine(int64_t d, Q16 eta, uint32_t& root) {
    constexpr uint64_t one_q32 = uint64_t{1} << 32, one_q62 = uint64_t{1} << 62, root_of_two_q32 = 0x16A09E667;
    const uint64_t cosine = shade16::min<uint64_t>(magnitude(d), root_of_two_q32);
    const bool beyond = cosine > one_q32;  // a rounded unit vector may be a little longer than 1
    const uint64_t sine_squared = cosine == 0 ? UINT64_MAX : beyond ? cosine * cosine : 0 - cosine * cosine;  // Q64, less 2^64 where it passes
    const uint64_t eta_squared = multiply(magnitude(eta.raw), magnitude(eta.raw));
    const int zeros = shade16::min<int>(leading_zeros(eta_squared), 63), spare = zeros - 30;
    uint64_t t = mulhi(eta_squared << zeros, sine_squared);  // the sine behind the surface, squared, with 32 + zeros fraction bits
    if (spare >= 0) t >>= spare;
    else t = t > one_q62 >> -spare ? one_q62 + 1 : t << -spare;
    if (!beyond && t > one_q62) return false;
    root = rounded_root(beyond ? one_q62 + shade16::min<uint64_t>(t, one_q62) : one_q62 - t);
    return true;
}
}  // namespace detail

/// sqrt(v.v)
/// Range   any; saturates.  Error  length_max_error: the nearest number.  Cost  a multiply a component and rounded_root.
template <FloatVector A>
constexpr Q16 length(const A& v) {
    return Q16::from_raw(static_cast<int32_t>(shade16::min<uint32_t>(rounded_root(detail::square(v)), INT32_MAX)));
}
constexpr Q16 length(Q16 x) { return abs(x); }

/// length(a - b). Error: that of length.
template <FloatVector A>
constexpr Q16 distance(const A& a, const Value<A>& b) { return length(a - b); }
constexpr Q16 distance(Q16 a, Q16 b) { return abs(a - b); }

/// v / |v|
/// Range   any; a zero vector gives a zero vector.
/// Error   normalize_max_error a component.  Cost  that of normalize_finely.
/// Source  block-floating shift, then x / sqrt(x.x) with two Newton steps.
template <FloatVector A>
constexpr Value<A> normalize(const A& a) {
    const Value<A> v = a;
    uint32_t bits = 0;
    detail::each<Value<A>>([&bits](Q16 x) { return bits |= magnitude(x.raw), x; }, v);
    if (bits == 0) return v;
    const int up = leading_zeros(bits) - 2;  // so that the sum of squares is at most 2^62
    using Fixed = Vector<int32_t, A::size>;
    const Fixed m = detail::each<Fixed>([up](Q16 x) { return up >= 0 ? shift_left(x.raw, up) : shift_right_round(x.raw, -up); }, v);
    const uint64_t s = detail::sum_of([](int32_t x) { return static_cast<uint64_t>(multiply(x, x)); }, m);
    const int zeros = leading_zeros(s) & ~1;
    const uint32_t mantissa = static_cast<uint32_t>((s << zeros) >> 32);
    const uint32_t r = shade16::detail::rsqrt_step(rsqrt_newton(mantissa), mantissa);  // 1/sqrt(s) = r 2^(zeros / 2 - 63)
    const int down = 47 - zeros / 2;
    return detail::each<Value<A>>([r, down](int32_t x) { return Q16::from_raw(static_cast<int32_t>(shift_right_round(multiply(x, r), down))); }, m);
}
constexpr Q16 normalize(Q16 x) { return sign(x); }

/// a x b, three components each.
/// Range   any; saturates.  Error  cross_max_error.
template <FloatVector A>
    requires(A::size == 3)
constexpr vec3 cross(const A& a, const vec3& b) {
    return vec3(shade16::cross(Vec3(vec3(a)), Vec3(b)));
}

/// n, turned so that it faces against the incident direction i: n where nref.i < 0, else -n.
/// Range   any.  Error  none.
template <FloatVector A>
constexpr Value<A> faceforward(const A& n, const Value<A>& i, const Value<A>& nref) {
    const Value<A> v = n;
    return detail::dot_q32(nref, i) < 0 ? v : -v;
}

/// i - 2 (n.i) n: the direction that a mirror with the unit normal n sends i to.
/// Range   any i; n no longer than 2, else the error grows with it. Saturates.
/// Error   reflect_max_error; from 2 |n.i| = 16 also 2^reflect_max_relative_error_log2 of it.
/// Cost    a dot and a long multiply a component, with shifts: M3 244 instructions, M0+ 729 (three components).
template <FloatVector A>
constexpr Value<A> reflect(const A& i, const Value<A>& n) {
    const Value<A> v = i;
    const detail::Factor k(2 * detail::dot_q32(n, v));
    return detail::each<Value<A>>([k](Q16 p, Q16 q) { return detail::less_multiple(int64_t{p.raw} * 65536, k, q); }, v, n);
}

/// eta i - (eta n.i + sqrt(1 - eta^2 (1 - (n.i)^2))) n: i as it goes on behind a surface; the zero vector where all of it
/// is reflected.
/// Range   unit vectors i and n, and any eta; longer ones count as |n.i| = 1.41.
/// Error   refract_max_error for eta up to 4.  Cost  a dot, a 64-bit multiply and a root.
template <FloatVector A>
constexpr Value<A> refract(const A& i, const Value<A>& n, Q16 eta) {
    const Value<A> v = i;
    const int64_t d = detail::dot_q32(n, v);
    uint32_t root = 0;
    if (!detail::refracted_cosine(d, eta, root)) return {};
    const detail::Factor k(shift_right_round(multiply(eta.raw, saturate(shift_right_round(d, 2))), 14) + 2 * int64_t{root});
    return detail::each<Value<A>>([k, eta](Q16 p, Q16 q) { return detail::less_multiple(multiply(eta.raw, p.raw), k, q); }, v, n);
}

}  // namespace shade16::glsl
