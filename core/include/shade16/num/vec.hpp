// Three-component vectors of any of the number types, with GLM's function names.
#pragma once

#include "shade16/num/mulhi.hpp"
#include "shade16/num/q16.hpp"
#include "shade16/num/q30.hpp"
#include "shade16/num/unit14.hpp"

namespace shade16 {

template <class T>
struct Vector3 {
    T x{}, y{}, z{};
    friend constexpr bool operator==(Vector3, Vector3) = default;
};

using Vec3 = Vector3<Q16>;        // positions and directions as a user writes them
using Normal14 = Vector3<Unit14>;  // unit vectors, 16 bit
using Normal30 = Vector3<Q30>;    // unit vectors, 32 bit
using IVec3 = Vector3<int32_t>;   // raw coordinates in the units of whoever made them

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, Q16 k) { return {a.x * k, a.y * k, a.z * k}; }

constexpr IVec3 raw(Vec3 v) { return {v.x.raw, v.y.raw, v.z.raw}; }
constexpr IVec3 raw(Normal14 v) { return {v.x.raw, v.y.raw, v.z.raw}; }
constexpr IVec3 raw(Normal30 v) { return {v.x.raw, v.y.raw, v.z.raw}; }

/// a.b of two unit vectors as a Q28 number.
/// Range   |a|, |b| <= 1.001, else the sum may leave 32 bits.  Error  none.  Cost  3 multiplies.  Source  the sum of products.
SHADE16_INLINE constexpr int32_t dot(Normal14 a, Normal14 b) {
    return int32_t{a.x.raw} * b.x.raw + int32_t{a.y.raw} * b.y.raw + int32_t{a.z.raw} * b.z.raw;
}

/// a.b of two unit vectors as a Q60 number.
/// Range   |a| |b| < 8; beyond that modulo 2^64.  Error  none.  Cost  three long multiplies.  Source  the sum of products.
constexpr int64_t dot(Normal30 a, Normal30 b) {
    const auto product = [](Q30 p, Q30 q) { return static_cast<uint64_t>(multiply(p.raw, q.raw)); };
    return static_cast<int64_t>(product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z));
}

inline constexpr Ulps vec3_dot_max_error = 0.501_ulps, vec3_cross_max_error = 0.501_ulps;

/// a.b, one rounding at the end, saturated.
/// Range   any; saturates: the three products are summed in 64 bits, less two bits each, so that full-range operands fit.
/// Error   vec3_dot_max_error.  Cost  three long multiplies.  Source  one rounding of the sum.
constexpr Q16 dot(Vec3 a, Vec3 b) {
    const int64_t quarter_sum = (multiply(a.x.raw, b.x.raw) >> 2) + (multiply(a.y.raw, b.y.raw) >> 2) + (multiply(a.z.raw, b.z.raw) >> 2);
    return Q16::from_raw(saturate(shift_right_round(quarter_sum, 14)));
}

/// a x b, each component with one rounding, saturated.
/// Range   any.  Error  vec3_cross_max_error, a component.  Cost  six long multiplies.  Source  each product less a bit.
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    const auto component = [](Q16 p, Q16 q, Q16 r, Q16 s) {
        return Q16::from_raw(saturate(shift_right_round((multiply(p.raw, q.raw) >> 1) - (multiply(r.raw, s.raw) >> 1), 15)));
    };
    return {component(a.y, b.z, a.z, b.y), component(a.z, b.x, a.x, b.z), component(a.x, b.y, a.y, b.x)};
}

}  // namespace shade16
