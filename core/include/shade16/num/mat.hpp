// Rotations and rigid transforms. A rotation is stored in Q30, so that it stays orthonormal to 1e-9: light can then be
// computed in the object's own frame, where stored normals need no transform, without losing the promise.
#pragma once

#include "shade16/num/angle.hpp"
#include "shade16/num/vec.hpp"

namespace shade16 {

/// A 3x3 matrix by rows, entries in [-2, 2).
struct Mat3 {
    Normal30 row[3] = {{{Q30::one}, {}, {}}, {{}, {Q30::one}, {}}, {{}, {}, {Q30::one}}};
    friend constexpr bool operator==(const Mat3&, const Mat3&) = default;
};

constexpr Mat3 transpose(const Mat3& m) {
    return {{{m.row[0].x, m.row[1].x, m.row[2].x}, {m.row[0].y, m.row[1].y, m.row[2].y}, {m.row[0].z, m.row[1].z, m.row[2].z}}};
}

inline constexpr Ulps mat3_product_max_error = 0.5_ulps;  // of Q30

/// The matrix product.
/// Range   rows and columns no longer than 1.15 (rotations), so that three products fit 64 bits.
/// Error   mat3_product_max_error, an entry.  Cost  27 long multiplies.  Source  rows times columns, rounded once.
SHADE16_ONCE constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
    const Mat3 columns = transpose(b);
    Mat3 product;
    for (int i = 0; i < 3; ++i) {
        const auto entry = [&](const Normal30& column) { return Q30::from_raw(shift_right_round(dot(a.row[i], column), 30)); };
        product.row[i] = {entry(columns.row[0]), entry(columns.row[1]), entry(columns.row[2])};
    }
    return product;
}

inline constexpr Ulps rotate_max_error = 0.501_ulps;  // of the result

/// m * v in the units of v, with `extra_bits` more fraction bits than v, each component rounded once and saturated.
/// Range   any v; extra_bits from 0 to 14.
/// Error   rotate_max_error.  Cost  nine long multiplies.  Source  three products, each less two bits, summed in 64 and rounded once.
SHADE16_ONCE constexpr IVec3 rotate(const Mat3& m, IVec3 v, int extra_bits = 0) {
    const auto component = [&](const Normal30& r) {
        const int64_t quarter = (multiply(r.x.raw, v.x) >> 2) + (multiply(r.y.raw, v.y) >> 2) + (multiply(r.z.raw, v.z) >> 2);
        return saturate(shift_right_round(quarter, 28 - extra_bits));
    };
    return {component(m.row[0]), component(m.row[1]), component(m.row[2])};
}

/// m * v.  Range  any v.  Error  rotate_max_error, of Q16.  Cost, Source  rotate.
constexpr Vec3 operator*(const Mat3& m, Vec3 v) {
    const IVec3 r = rotate(m, raw(v));
    return {Q16::from_raw(r.x), Q16::from_raw(r.y), Q16::from_raw(r.z)};
}

/// Rotations about an axis, counter-clockwise when it points at you. Error: that of sincos.
constexpr Mat3 rotate_x(Angle a) {
    const auto [s, c] = sincos(a);
    return {{{{Q30::one}, {}, {}}, {{}, c, -s}, {{}, s, c}}};
}
constexpr Mat3 rotate_y(Angle a) {
    const auto [s, c] = sincos(a);
    return {{{c, {}, s}, {{}, {Q30::one}, {}}, {-s, {}, c}}};
}
constexpr Mat3 rotate_z(Angle a) {
    const auto [s, c] = sincos(a);
    return {{{c, -s, {}}, {s, c, {}}, {{}, {}, {Q30::one}}}};
}

/// A rigid transform: v -> rotation * v + translation.
struct Mat3x4 {
    Mat3 rotation{};
    Vec3 translation{};
    friend constexpr bool operator==(const Mat3x4&, const Mat3x4&) = default;
};

/// A point, moved.  Range  any; saturates.  Error  that of rotate.  Cost, Source  rotate.
constexpr Vec3 operator*(const Mat3x4& m, Vec3 v) { return m.rotation * v + m.translation; }
/// First b, then a.  Range  any; saturates.  Error, Cost, Source  those of both products.
constexpr Mat3x4 operator*(const Mat3x4& a, const Mat3x4& b) { return {a.rotation * b.rotation, a * b.translation}; }
inline constexpr Ulps inverse_max_error = 3_ulps;  // of Q16, there and back again

/// The inverse of a rigid transform: the transposed rotation.
/// Range   translations and points up to 2048.  Error  inverse_max_error.
/// Cost    rotate.  Source  (R v + t) undone is R^T v - R^T t.
constexpr Mat3x4 inverse(const Mat3x4& m) {
    const Mat3 back = transpose(m.rotation);
    return {back, -(back * m.translation)};
}

}  // namespace shade16
