// Edges of small triangles, by one addition a row.
#pragma once

#include "shade16/num/reciprocal.hpp"
#include "shade16/pipeline/setup.hpp"

namespace shade16 {

/// Up to this width plus height of its box in pixels, a triangle is small: so no edge is 896 sub-pixels wide or high. Its
/// packed word is exact at the middle pixel of the box, 28 steps of at most 1/64 code from any other.
inline constexpr int32_t small_triangle_px = 56;

/// Small, and inside the frame from left to right. The same for every band.
SHADE16_INLINE constexpr bool is_small(const PixelBox& whole, int32_t frame_width) {
    const int32_t to_spare = small_triangle_px - (whole.right - whole.left) - (whole.bottom - whole.top);
    return (to_spare | whole.left | (frame_width - whole.right)) >= 0;  // none is negative
}

namespace detail {
/// The first pixel centre at or beyond v, in pixels from the one that v counts from, in 1/16 pixel.
SHADE16_INLINE constexpr int32_t centre_beyond(int32_t v) { return (v + 15) >> 4; }

/// A left or right edge of a small triangle. Points count from a pixel's centre, rows and columns from that pixel.
/// Range   |dx|, dy < 896, dy > 0; rows of the edge.
/// Error   none: an edge's crossing is a multiple of 1 / (16 dy), so at least 73 units of 2^-20 from any other whole number.
///         Steps fall short by one unit at most in 57 of them; 8 units off the ceiling's bias leave whole crossings whole
///         and all others above.
/// Cost    one quotient an edge, one addition a row.
class SmallEdge {
public:
    SHADE16_INLINE constexpr SmallEdge(RasterPoint from, RasterPoint to, int32_t row) {
        const int32_t rise = shift_left(to.x - from.x, 20), below = shift_left(row, 4) - from.y;
        slope_ = quotient_below(rise, static_cast<uint32_t>(to.y - from.y));
        x_ = shift_left(from.x + 16, 16) - 8 + sixteenth_of_product(slope_, below);
    }
    /// The first pixel at or right of the edge.
    SHADE16_INLINE constexpr int32_t column() const { return x_ >> 20; }
    SHADE16_INLINE constexpr void next_row() { x_ = opaque(x_ + slope_); }

private:
    /// At most n / d, by less than 2.
    SHADE16_INLINE static constexpr int32_t quotient_below(int32_t n, uint32_t d) {
#if SHADE16_HAS_DIVIDER
        return n / static_cast<int32_t>(d) + (n >> 31);
#else
        return n >= 0 ? static_cast<int32_t>(quotient(static_cast<uint32_t>(n), d)) : -1 - static_cast<int32_t>(quotient(static_cast<uint32_t>(-n), d));
#endif
    }
    /// floor(a * b / 16).
    SHADE16_INLINE static constexpr int32_t sixteenth_of_product(int32_t a, int32_t b) {
#if SHADE16_NARROW_MULTIPLY
        return (a >> 4) * b + ((a & 15) * b >> 4);
#else
        return static_cast<int32_t>(multiply(a, b) >> 4);
#endif
    }
    int32_t x_ = 0, slope_ = 0;  // 12.20
};
}  // namespace detail

}  // namespace shade16
