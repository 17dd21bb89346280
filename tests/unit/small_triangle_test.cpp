#include "shade16/pipeline/small_triangle.hpp"

#include <gtest/gtest.h>

#include <random>

namespace shade16 {
namespace {

constexpr int32_t limit = small_triangle_px * 16;  // no edge is so wide or high

// Every slope of its range, each from a few corners: one addition a row must not miss a pixel.
TEST(SmallTriangle, AnEdgeIsExactWithOneAdditionARow) {
    std::mt19937 random{24};
    for (int32_t dy = 1; dy < limit; ++dy)
        for (int32_t dx = 1 - limit; dx < limit; ++dx) {
            const RasterPoint from{static_cast<int32_t>(random() % limit) - limit / 2, static_cast<int32_t>(random() % limit) - limit / 2};
            const int32_t top = detail::centre_beyond(from.y), end = detail::centre_beyond(from.y + dy);
            const int32_t start = top + static_cast<int32_t>(random() % 4);
            if (start >= end) continue;
            detail::SmallEdge edge(from, {from.x + dx, from.y + dy}, start);
            for (int32_t row = start; row < end; ++row, edge.next_row()) {
                // The first whole column at or right of x + dx (16 row - y) / dy, which is in 1/16 pixel.
                const int32_t numerator = from.x * dy + dx * (16 * row - from.y), cell = 16 * dy;
                const int32_t exact = numerator > 0 ? (numerator + cell - 1) / cell : -(-numerator / cell);
                ASSERT_EQ(edge.column(), exact) << from.x << ' ' << from.y << ' ' << dx << ' ' << dy << " row " << row;
            }
        }
}

TEST(SmallTriangle, IsInsideTheFrameFromLeftToRight) {
    static_assert(is_small({0, 30, 5, 31}, 30) && !is_small({0, 30, 5, 31}, 29) && !is_small({-1, 30, 5, 30}, 30));
    static_assert(is_small({10, 20, -1000, -970}, 320));  // rows may be anywhere: a band may begin anywhere
    static_assert(is_small({0, 1, 0, 55}, 320) && !is_small({0, 1, 0, 56}, 320) && !is_small({0, 56, 0, 1}, 320));
}

}  // namespace
}  // namespace shade16
