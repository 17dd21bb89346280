#include "shade16/pipeline/edge.hpp"

#include <gtest/gtest.h>

#include <random>

namespace shade16 {
namespace {

int64_t floor_div(int64_t n, int64_t d) { return n >= 0 ? n / d : -((-n + d - 1) / d); }

// The first column whose centre lies at or right of the edge, at the centre of a row.
int64_t exact_pixel(int64_t x, int64_t y, int64_t dx, int64_t dy, int64_t row) {
    const int64_t below = row * 16 + 8 - y;  // x_edge = x + dx * below / dy; ceil((x_edge - 8) / 16)
    return -floor_div(-((x - 8) * dy + dx * below), 16 * dy);
}

TEST(Edge, FirstCentreRoundsUpToTheNextCentre) {
    static_assert(first_centre(8) == 0 && first_centre(9) == 1 && first_centre(7) == 0 && first_centre(-8) == -1 && first_centre(-7) == 0);
    for (int32_t v = -100; v < 100; ++v) {
        const int32_t first = first_centre(v);
        ASSERT_GE(first * 16 + 8, v);
        ASSERT_LT((first - 1) * 16 + 8, v);
    }
}

void check_walk(int32_t x, int32_t y, int32_t dx, int32_t dy, int32_t start, int32_t rows) {
    const int32_t top = first_centre(y), end = first_centre(y + dy);
    EdgeWalker edge(x, y, dx, dy, top + start);
    for (int32_t row = top + start; row < end && row < top + start + rows; ++row) {
        ASSERT_EQ(edge.column(), exact_pixel(x, y, dx, dy, row)) << x << ' ' << y << ' ' << dx << ' ' << dy << " row " << row;
        edge.next_row();
    }
}

TEST(Edge, WalksExactlyFromItsTop) {
    std::mt19937 random{22};
    for (int i = 0; i < 100'000; ++i) {
        const int shift = static_cast<int>(random() % 16);
        const auto number = [&] { return static_cast<int32_t>(random() & 0xFFFF) - 0x8000; };
        const int32_t dy = (static_cast<int32_t>(random() & 0xFFFF) >> shift) + 1;
        check_walk(number(), number(), (number() * 2) >> (shift * static_cast<int>(random() & 1)), dy, 0, 60);
    }
}

TEST(Edge, StartsExactlyAtAnyRow) {
    std::mt19937 random{23};
    for (int i = 0; i < 100'000; ++i) {
        const auto number = [&] { return static_cast<int32_t>(random() & 0xFFFF) - 0x8000; };
        const int32_t dy = static_cast<int32_t>(random() & 0xFFFF) + 1;
        check_walk(number(), number(), number() * 2, dy, static_cast<int32_t>(random() % 4096), 3);
    }
}

TEST(Edge, HoldsAtTheEndsOfItsRange) {
    for (const int32_t x : {-32768, 0, 32767})
        for (const int32_t y : {-32768, -1, 0, 7, 8, 9, 32767})
            for (const int32_t dx : {-65536, -65535, -1, 0, 1, 65535, 65536})
                for (const int32_t dy : {1, 2, 15, 16, 17, 65535, 65536})
                    for (const int32_t start : {0, 1, 4000}) check_walk(x, y, dx, dy, start, 100);
}

}  // namespace
}  // namespace shade16
