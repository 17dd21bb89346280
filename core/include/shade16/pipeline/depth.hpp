// Depth: 16 bits, nearer is smaller, stepped as Q16 in 32 bits.
#pragma once

#include "shade16/pipeline/setup.hpp"

namespace shade16 {

/// Depth over one triangle: its value at the reference pixel of the current row, and its slopes.
struct DepthPlane {
    uint32_t value = 0;
    int32_t step_x = 0, step_y = 0;

    constexpr DepthPlane() = default;  // where depth does not count
    template <PrecisionTier Tier>
    constexpr DepthPlane(const TriangleSetup<Tier>& t, RasterPoint from_corner) {
        const int32_t z0 = t.corner[0]->z, d1 = t.corner[1]->z - z0, d2 = t.corner[2]->z - z0;
        if (t.is_compact()) {
            // |slope| < 2^(17 + reach_bits): lifted to 30 bits, so that small triangles keep their digits.
            const int lift = 13 - t.reach_bits, right = 10 + lift - t.inverse.shift;
            step_x = mulhi(shift_left(t.slope_x(d1, d2), lift), t.inverse.mantissa);
            step_y = mulhi(shift_left(t.slope_y(d1, d2), lift), t.inverse.mantissa);
            if (right >= 0) step_x >>= min(right, 31), step_y >>= min(right, 31);
            else if ((magnitude(step_x) | magnitude(step_y)) >> max(30 + right, 0) == 0) step_x = shift_left(step_x, -right), step_y = shift_left(step_y, -right);
            else step_x = step_y = INT32_MAX;
        } else {
            step_x = t.inverse.times(t.long_slope_x(d1, d2), 20);
            step_y = t.inverse.times(t.long_slope_y(d1, d2), 20);
        }
        value = (static_cast<uint32_t>(z0) << 16) + static_cast<uint32_t>((step_x >> 4) * from_corner.x) +
                static_cast<uint32_t>((step_y >> 4) * from_corner.y);
    }
    /// Slopes too steep for 32 bits: a sliver seen edge on.
    constexpr bool is_steep() const {
        return (magnitude(step_x) | magnitude(step_y)) >= (uint32_t{1} << 30);
    }
    SHADE16_INLINE constexpr void next_row() { value += static_cast<uint32_t>(step_y); }
    constexpr void skip_rows(int32_t rows) { value += static_cast<uint32_t>(step_y) * static_cast<uint32_t>(rows); }
    SHADE16_INLINE constexpr uint32_t at(int32_t column) const {
        return value + static_cast<uint32_t>(step_x) * static_cast<uint32_t>(column);
    }
};

template <bool Depth, PrecisionTier Tier>
SHADE16_INLINE constexpr DepthPlane depth_plane(const TriangleSetup<Tier>& t, RasterPoint from_corner) {
    if constexpr (Depth) return DepthPlane(t, from_corner);
    else return {};
}

/// The depth test: true when the new value is nearer, and then it is kept.
template <bool Depth>
SHADE16_INLINE constexpr bool nearer(uint16_t* stored, uint32_t value) {
    if constexpr (!Depth) return true;
    const uint32_t z = value >> 16;
    if (z >= *stored) return false;
    *stored = static_cast<uint16_t>(z);
    return true;
}

}  // namespace shade16
