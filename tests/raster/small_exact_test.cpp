// Small triangles of grey targets, in both 16-bit tiers: their stepped lumas and depths against exact interpolation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "shade16/shade16.hpp"

namespace shade16 {
namespace {

using Tier = LumaTier<mediump>;
using Vertex = ScreenVertex<Tier>;

template <int Bits>
struct Fractions {
    struct Pixel {
        uint32_t luma = 0;
        bool is_drawn = false;
    };
    static constexpr int luma_bits = Bits;
    static constexpr Pixel pack(uint32_t) { return {}; }
    static constexpr Pixel from_q24(uint32_t luma) { return {luma, true}; }
};

constexpr int32_t size = 64;
static_assert(small_exact_max_error_per_65536_code < 64 * exact_stepping_max_error_per_1024_code);

/// A corner's value at the centre of a pixel.
double interpolated(const Vertex (&v)[3], const double (&at)[3], int32_t x, int32_t y) {
    const auto cross = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    const double px = (x - size / 2) * 16 + 8 - v[0].x, py = (y - size / 2) * 16 + 8 - v[0].y;
    const double ux = v[1].x - v[0].x, uy = v[1].y - v[0].y, wx = v[2].x - v[0].x, wy = v[2].y - v[0].y;
    const double area = cross(ux, uy, wx, wy);
    return at[0] + (at[1] - at[0]) * cross(px, py, wx, wy) / area + (at[2] - at[0]) * cross(ux, uy, px, py) / area;
}

struct Worst {
    double per_65536_code = 0, depth = 0;
    int pixels = 0, drawn_small = 0;
};

template <int Bits>
Worst worst_of(bool extremes) {
    using Format = Fractions<Bits>;
    std::mt19937 engine(Bits);
    const auto between = [&](int low, int high) { return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1)); };
    std::vector<typename Format::Pixel> pixels(size * size);
    std::vector<uint16_t> depth(size * size);
    const Band<Format> band{pixels.data(), depth.data(), size, 0, size};
    Worst worst;
    for (int i = 0; i < 40'000; ++i) {
        Vertex v[3];
        const int reach = i % 3 == 0 ? 60 : 220;
        double luma[3], z[3];
        const int base = between(first_depth, last_depth - 3000);  // steeper ones are drawn by the other painters
        for (int k = 0; k < 3; ++k) {
            v[k].x = static_cast<int16_t>(between(-reach, reach)), v[k].y = static_cast<int16_t>(between(-reach, reach));
            v[k].luma = static_cast<uint16_t>(extremes ? between(0, 1) * 32768 : between(0, 32768));
            v[k].z = static_cast<uint16_t>(base + between(0, 3000));
            luma[k] = v[k].luma / 32768.0 * ((1 << Bits) - 1), z[k] = v[k].z;
        }
        if (doubled_area(v[0], v[1], v[2]) >= 0) continue;
        const FacingTriangle<Tier> facing(v[0], v[1], v[2], {size * 8, size * 8}, 0, size);
        if (!facing.shows(size) || !is_small(facing.whole, size)) continue;
        std::fill(pixels.begin(), pixels.end(), typename Format::Pixel{});
        std::fill(depth.begin(), depth.end(), far_depth);
        if (!draw_small<true>(facing, band)) continue;
        ++worst.drawn_small;
        for (int32_t y = 0; y < size; ++y)
            for (int32_t x = 0; x < size; ++x) {
                const auto at = static_cast<std::size_t>(y * size + x);
                if (!pixels[at].is_drawn) continue;
                ++worst.pixels;
                const double error = pixels[at].luma / 16777216.0 - 0.5 - interpolated(v, luma, x, y);
                worst.per_65536_code = std::max(worst.per_65536_code, 65536 * std::abs(error));
                worst.depth = std::max(worst.depth, std::abs(depth[at] - interpolated(v, z, x, y)));
            }
    }
    ::testing::Test::RecordProperty("worst_per_65536_code", std::to_string(worst.per_65536_code));
    return worst;
}

template <int Bits>
void expect_within_bounds() {
    for (const bool extremes : {false, true}) {
        const Worst worst = worst_of<Bits>(extremes);
        EXPECT_GT(worst.drawn_small, 5'000);
        EXPECT_GT(worst.pixels, 200'000);
        EXPECT_LE(worst.per_65536_code, small_exact_max_error_per_65536_code) << Bits;
        EXPECT_LE(worst.depth, 2);
    }
}
TEST(SmallExact, EightBitsAreWithinTheExactBound) { expect_within_bounds<8>(); }
TEST(SmallExact, FourBitsAreWithinTheExactBound) { expect_within_bounds<4>(); }
TEST(SmallExact, OneBitIsWithinTheExactBound) { expect_within_bounds<1>(); }

}  // namespace
}  // namespace shade16
