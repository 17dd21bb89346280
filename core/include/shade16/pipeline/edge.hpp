// Edges on the pixel grid, exactly: the first pixel at or right of an edge, row by row, with an integer remainder.
#pragma once

#include "shade16/num/reciprocal.hpp"

namespace shade16 {

/// The first row whose centre lies at or below y, or the first column whose centre lies at or right of x; both in 1/16
/// pixel. A centre exactly on a top or left edge belongs to the triangle, one on a bottom or right edge does not.
SHADE16_INLINE constexpr int32_t first_centre(int32_t v) { return (v + 7) >> 4; }

/// Walks an edge that runs down from (x, y) by (dx, dy), dy > 0, in 1/16 pixel.
/// Range   |dx|, dy <= 2^16.  Error  none: equal to 64-bit edge functions, as the raster tests check on every pixel.
/// Cost    two quotients an edge, four or five instructions a row.
/// Source  the remainder stepping of Bresenham and of Hecker's Perspective Texture Mapping.
class EdgeWalker {
public:
    constexpr EdgeWalker() = default;
    SHADE16_ONCE constexpr EdgeWalker(int32_t x, int32_t y, int32_t dx, int32_t dy, int32_t row, int32_t reference = 0) {
        const uint32_t height = static_cast<uint32_t>(dy);
        whole_ = floor_quotient(dx, height);
        rest_ = static_cast<uint32_t>(dx - whole_ * dy);  // dx / dy = whole + rest / dy, 0 <= rest < dy
        height_ = height << 4;

        // ceil((x - 8 + dx * below / dy) / 16) as a floor, with x - 8 split so that the product stays in 32 bits.
        const int32_t top_row = first_centre(y), below = (top_row << 4) + 8 - y;  // below in [0, 16)
        const int32_t column = (x - 8) >> 4, within = (x - 8) & 15;
        const int32_t numerator = within * dy + dx * below + static_cast<int32_t>(height_) - 1;
        const int32_t cells = floor_quotient(numerator, height_);
        column_ = column + cells - reference;
        error_ = numerator - cells * static_cast<int32_t>(height_) - static_cast<int32_t>(height_);
        rest_ <<= 4;
        if (row > top_row) skip(row - top_row);
    }

    /// The first pixel at or right of the edge, in columns from the reference.
    SHADE16_INLINE constexpr int32_t column() const { return column_; }

    SHADE16_INLINE constexpr void next_row() {
        column_ += whole_;
        error_ += static_cast<int32_t>(rest_);
        if (error_ >= 0) {
            error_ -= static_cast<int32_t>(height_);
            ++column_;
        }
    }

private:
    /// As many next_row at once, for a band that starts below the edge's top.
    constexpr void skip(int32_t rows) {
        const uint32_t dy = height_ >> 4, rest = rest_ >> 4, error = static_cast<uint32_t>(error_ + static_cast<int32_t>(height_));
        const uint32_t numerator = rest * static_cast<uint32_t>(rows) + (error >> 4);
        const uint32_t cells = quotient(numerator, dy);
        column_ += whole_ * rows + static_cast<int32_t>(cells);
        error_ = static_cast<int32_t>(((numerator - cells * dy) << 4 | (error & 15)) - height_);
    }

    int32_t column_ = 0;
    int32_t error_ = 0;    // in [-height, 0)
    int32_t whole_ = 0;    // pixels a row
    uint32_t rest_ = 0;    // 16 * (dx mod dy)
    uint32_t height_ = 16;  // 16 * dy
};

}  // namespace shade16
