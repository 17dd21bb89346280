// Block: a signed mantissa and exponent for set-up code, where a matrix entry may be tiny and a translation huge.
#pragma once

#include "shade16/num/mat.hpp"
#include "shade16/num/reciprocal.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16 {

/// Relative errors; a sum's of its larger operand, a rotation's of its largest component.
inline constexpr int block_shortened_max_error_log2 = -31, block_product_max_error_log2 = -31;
inline constexpr int block_sum_max_error_log2 = -60, block_rotation_max_error_log2 = -29;
inline constexpr Ulps block_units_max_error = 0.5_ulps;  // of Block::in_units_of, in its units

/// The number mantissa * 2^exponent.
struct Block {
    int64_t mantissa = 0;
    int32_t exponent = 0;

    /// The same number with at most 31 significant bits, rounded.  Range  any.  Error  block_shortened_max_error_log2.
    /// Cost    a count of zeros, a 64-bit shift.  Source  the top bits.
    SHADE16_ONCE constexpr Block shortened() const {
        const int excess = 33 - leading_zeros(magnitude(mantissa));
        return excess > 0 ? Block{shift_right_round(mantissa, excess), exponent + excess} : *this;
    }
    /// The smallest p for which |number| < 2^p; -1000 for 0, which is below every number of interest.
    constexpr int32_t top() const { return mantissa == 0 ? -1000 : 64 - leading_zeros(magnitude(mantissa)) + exponent; }
    /// The number in units of 2^unit, rounded and saturated to 32 bits. Error: block_units_max_error.
    constexpr int32_t in_units_of(int32_t unit) const { return scale_by_power_of_two(mantissa, exponent - unit); }

    /// The product.
    /// Range   any.  Error  block_product_max_error_log2.  Cost  shortened and a long multiply.
    /// Source  mantissas multiplied, exponents added.
    SHADE16_ONCE friend constexpr Block operator*(Block a, Scaled b) {
        const Block s = a.shortened();
        return {multiply(static_cast<int32_t>(clamp<int64_t>(s.mantissa, INT32_MIN, INT32_MAX)), b.mantissa), s.exponent + b.exponent - 32};
    }
    /// The sum.
    /// Range   any.  Error  block_sum_max_error_log2, of the larger.  Cost  two 64-bit shifts.
    /// Source  both aligned three bits below the top of 64.
    SHADE16_ONCE friend constexpr Block operator+(Block a, Block b) {
        if (a.mantissa == 0) return b;
        if (b.mantissa == 0) return a;
        const int32_t unit = max(a.top(), b.top()) - 61;
        const auto aligned = [unit](Block x) {
            const int32_t shift = x.exponent - unit;
            if (shift >= 0) return static_cast<int64_t>(static_cast<uint64_t>(x.mantissa) << shift);
            return shift > -64 ? shift_right_round(x.mantissa, static_cast<int>(-shift)) : 0;
        };
        return {aligned(a) + aligned(b), unit};
    }
    /// Range   mantissas above INT64_MIN, which no operation makes; that one stays.
    friend constexpr Block operator-(Block a) { return {static_cast<int64_t>(0 - static_cast<uint64_t>(a.mantissa)), a.exponent}; }
    friend constexpr Block operator-(Block a, Block b) { return a + -b; }
};

struct BlockVector {
    Block x, y, z;

    constexpr int32_t top() const { return max(x.top(), max(y.top(), z.top())); }
    SHADE16_ONCE constexpr IVec3 in_units_of(int32_t unit) const { return {x.in_units_of(unit), y.in_units_of(unit), z.in_units_of(unit)}; }
    SHADE16_ONCE friend constexpr BlockVector operator+(const BlockVector& a, const BlockVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    SHADE16_ONCE friend constexpr BlockVector operator-(const BlockVector& a, const BlockVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    SHADE16_ONCE friend constexpr BlockVector operator*(const BlockVector& a, Scaled k) { return {a.x * k, a.y * k, a.z * k}; }
};

constexpr BlockVector as_block(Vec3 v) { return {{v.x.raw, -16}, {v.y.raw, -16}, {v.z.raw, -16}}; }

/// a * b by component, exactly.
SHADE16_ONCE constexpr BlockVector component_product(Vec3 a, Vec3 b) {
    return {{multiply(a.x.raw, b.x.raw), -32}, {multiply(a.y.raw, b.y.raw), -32}, {multiply(a.z.raw, b.z.raw), -32}};
}

/// m * v.
/// Range   exponents above -1000.  Error  block_rotation_max_error_log2.  Cost  nine long multiplies.  Source  v in units of its largest component.
SHADE16_ONCE constexpr BlockVector operator*(const Mat3& m, const BlockVector& v) {
    const int32_t unit = v.top() - 30;
    const IVec3 mantissas = v.in_units_of(unit);
    const auto component = [&](const Normal30& r) {
        return Block{multiply(r.x.raw, mantissas.x) + multiply(r.y.raw, mantissas.y) + multiply(r.z.raw, mantissas.z), unit - 30};
    };
    return {component(m.row[0]), component(m.row[1]), component(m.row[2])};
}

}  // namespace shade16
