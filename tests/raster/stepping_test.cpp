// Colours and depth against exact interpolation, on the pixels of random triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mock_framebuffer.hpp"

namespace shade16::test {
namespace {

struct Random {
    explicit Random(uint64_t seed) : engine(seed) {}
    std::mt19937_64 engine;
    int32_t between(int32_t low, int32_t high) { return low + static_cast<int32_t>(engine() % static_cast<uint64_t>(high - low + 1)); }
};

// From a few pixels to the guard band; every fifth one a sliver.
void random_corners(Random& random, int i, int32_t width, int32_t height, Point (&p)[3]) {
    const int32_t reach = (16 << (i % 12)) < 2 * guard_extent ? 16 << (i % 12) : 2 * guard_extent;
    const Point middle{random.between(0, width * 16), random.between(0, height * 16)};
    for (Point& corner : p) corner = {middle.x + random.between(-reach, reach), middle.y + random.between(-reach, reach)};
    if (i % 5 == 0) p[2] = {(p[0].x + p[1].x) / 2 + random.between(-5, 5), (p[0].y + p[1].y) / 2 + random.between(-5, 5)};
    for (Point& corner : p) {
        corner.x = std::clamp(corner.x, width * 8 - guard_extent, width * 8 + guard_extent);
        corner.y = std::clamp(corner.y, height * 8 - guard_extent, height * 8 + guard_extent);
    }
}

struct Worst {
    double code = 0;      // before rounding, in codes
    int rounded = 0;      // after rounding, in codes
    double depth = 0;     // in 1/65536
    long pixels = 0;
};

enum class Colors { any, extremes, grey };

template <class Format, Stepping Step, class Tier, bool Depth>
Worst worst_errors(uint64_t seed, int count, int32_t width, int32_t height, Colors colors) {
    Random random(seed);
    Worst worst;
    constexpr double one = 1 << ScreenVertex<Tier>::channel_bits;
    MockFramebuffer<Format, Depth> frame(width, height);
    for (int i = 0; i < count; ++i) {
        Point p[3];
        random_corners(random, i, width, height, p);
        ScreenVertex<Tier> v[3];
        double r[3], g[3], b[3], z[3];
        for (int k = 0; k < 3; ++k) {
            v[k] = frame.template vertex<Tier>(p[k]);
            const auto channel = [&] {
                const int32_t any = random.between(0, static_cast<int32_t>(one));
                return static_cast<typename ScreenVertex<Tier>::Channel>(colors == Colors::extremes ? (any & 1) * static_cast<int32_t>(one) : any);
            };
            v[k].r = channel();
            v[k].g = colors == Colors::grey ? v[k].r : channel();
            v[k].b = colors == Colors::grey ? v[k].r : channel();
            v[k].z = static_cast<uint16_t>(random.between(first_depth, last_depth));
            r[k] = v[k].r / one * ((1 << Format::red_bits) - 1), g[k] = v[k].g / one * ((1 << Format::green_bits) - 1);
            b[k] = v[k].b / one * ((1 << Format::blue_bits) - 1), z[k] = v[k].z;
        }
        frame.template draw<Step>(v[0], v[1], v[2]);
        for (int32_t y = 0; y < height; ++y)
            for (int32_t x = 0; x < width; ++x) {
                if (frame.at(x, y).writes == 0) continue;
                const Codes codes = frame.at(x, y).codes;
                const auto check = [&](double got, const double (&corner)[3], int bits) {
                    const double exact = interpolate_exactly(p, corner, x, y);
                    worst.code = std::fmax(worst.code, std::fabs(got - 0.5 - exact));
                    const int rounded = static_cast<int>(std::floor(got));
                    EXPECT_GE(rounded, 0);
                    EXPECT_LT(rounded, 1 << bits);
                    worst.rounded = std::max(worst.rounded, std::abs(rounded - static_cast<int>(std::floor(exact + 0.5))));
                };
                check(codes.r, r, Format::red_bits);
                check(codes.g, g, Format::green_bits);
                check(codes.b, b, Format::blue_bits);
                if (colors == Colors::grey) { EXPECT_EQ(std::floor(codes.r), std::floor(codes.b)) << "grey must stay grey"; }
                if constexpr (Depth) worst.depth = std::fmax(worst.depth, std::fabs(frame.depth_at(x, y) - interpolate_exactly(p, z, x, y)));
                ++worst.pixels;
            }
        frame.reset();
        if (::testing::Test::HasFailure()) {
            ADD_FAILURE() << "triangle (" << p[0].x << ", " << p[0].y << ") (" << p[1].x << ", " << p[1].y << ") (" << p[2].x << ", " << p[2].y << ')';
            break;
        }
    }
    ::testing::Test::RecordProperty("worst_per_1024_code", std::to_string(worst.code * 1024));
    ::testing::Test::RecordProperty("worst_rounded", std::to_string(worst.rounded));
    if (Depth) ::testing::Test::RecordProperty("worst_depth", std::to_string(worst.depth));
    EXPECT_GT(worst.pixels, count);
    return worst;
}

constexpr double packed_bound = packed_stepping_max_error_per_1024_code / 1024.0, exact_bound = exact_stepping_max_error_per_1024_code / 1024.0;

TEST(PackedStepping, IsWithinItsBoundAndOneCode) {
    const Worst worst = worst_errors<Counted565, Stepping::packed, mediump, false>(1, 20'000, 120, 90, Colors::any);
    EXPECT_LE(worst.code, packed_bound);
    EXPECT_LE(worst.rounded, 1);
}
TEST(PackedStepping, IsWithinItsBoundForTheSteepestColours) {
    const Worst worst = worst_errors<Counted565, Stepping::packed, lowp, false>(2, 20'000, 120, 90, Colors::extremes);
    EXPECT_LE(worst.code, packed_bound);
    EXPECT_LE(worst.rounded, 1);
}
TEST(PackedStepping, IsWithinItsBoundOverTheWidestAndTheHighestFrame) {
    const Worst wide = worst_errors<Counted565, Stepping::packed, mediump, false>(3, 600, max_target_px, 8, Colors::extremes);
    EXPECT_LE(wide.code, packed_bound);
    const Worst high = worst_errors<Counted565, Stepping::packed, mediump, false>(4, 600, 8, max_target_px, Colors::extremes);
    EXPECT_LE(high.code, packed_bound);
}
TEST(PackedStepping, IsWithinItsBoundFromWideVertices) {
    const Worst worst = worst_errors<Counted565, Stepping::packed, highp, false>(5, 10'000, 120, 90, Colors::any);
    EXPECT_LE(worst.code, packed_bound);
    EXPECT_LE(worst.rounded, 1);
}
TEST(PackedStepping, KeepsGreyGrey) { worst_errors<Counted565, Stepping::packed, mediump, false>(6, 10'000, 120, 90, Colors::grey); }

TEST(ExactStepping, IsWithinItsBound) {
    const Worst worst = worst_errors<Counted888, Stepping::exact, highp, false>(7, 20'000, 120, 90, Colors::any);
    EXPECT_LE(worst.code, exact_bound);
    EXPECT_LE(worst.rounded, 1);
}
TEST(ExactStepping, IsWithinItsBoundForTheSteepestColours) {
    EXPECT_LE((worst_errors<Counted888, Stepping::exact, highp, false>(8, 20'000, 120, 90, Colors::extremes).code), exact_bound);
}
TEST(ExactStepping, IsWithinItsBoundFromSixteenBitVertices) {
    EXPECT_LE((worst_errors<Counted888, Stepping::exact, mediump, false>(9, 20'000, 120, 90, Colors::any).code), exact_bound);
}
TEST(ExactStepping, IsWithinItsBoundOverTheWidestAndTheHighestFrame) {
    EXPECT_LE((worst_errors<Counted888, Stepping::exact, highp, false>(10, 600, max_target_px, 8, Colors::extremes).code), exact_bound);
    EXPECT_LE((worst_errors<Counted888, Stepping::exact, highp, false>(11, 600, 8, max_target_px, Colors::extremes).code), exact_bound);
}
TEST(ExactStepping, KeepsGreyGrey) { worst_errors<Counted565, Stepping::exact, highp, false>(12, 10'000, 120, 90, Colors::grey); }

TEST(Depth, IsWithinTwoOfExactInterpolation) {
    EXPECT_LE((worst_errors<Counted565, Stepping::packed, mediump, true>(13, 20'000, 120, 90, Colors::any).depth), 2);
    EXPECT_LE((worst_errors<Counted565, Stepping::exact, highp, true>(14, 5'000, 120, 90, Colors::any).depth), 2);
}
TEST(Depth, IsWithinTwoOfExactInterpolationOverTheWidestFrame) {
    EXPECT_LE((worst_errors<Counted565, Stepping::packed, mediump, true>(15, 600, max_target_px, 8, Colors::any).depth), 2);
}

TEST(Depth, TheNearerOfTwoTrianglesWins) {
    for (const bool near_first : {false, true}) {
        MockFramebuffer<Counted565, true> frame(16, 16);
        const auto draw = [&frame](uint16_t z, uint16_t r) {
            ScreenVertex<mediump> v[3] = {frame.vertex<mediump>({0, 0}), frame.vertex<mediump>({600, 0}), frame.vertex<mediump>({0, 600})};
            for (auto& corner : v) corner.z = z, corner.r = r;
            frame.draw<Stepping::packed>(v[0], v[1], v[2]);
        };
        draw(near_first ? 100 : 200, near_first ? 32768 : 0);
        draw(near_first ? 200 : 100, near_first ? 0 : 32768);
        for (int32_t y = 0; y < 16; ++y)
            for (int32_t x = 0; x < 16; ++x) {
                ASSERT_EQ(std::floor(frame.at(x, y).codes.r), 31);
                ASSERT_EQ(frame.depth_at(x, y), 100);
                ASSERT_EQ(frame.at(x, y).writes, near_first ? 1 : 2);
            }
    }
}

// A band is a window on the frame: a pixel has the same bits whatever band it is drawn in.
TEST(Bands, GiveTheBitsOfTheFullFrame) {
    Random random(16);
    constexpr int32_t width = 100, height = 80;
    for (int i = 0; i < 3000; ++i) {
        Point p[3];
        random_corners(random, i, width, height, p);
        std::vector<uint16_t> full(width * height), full_depth(full.size(), far_depth), banded(full), banded_depth(full_depth);
        ScreenVertex<mediump> v[3];
        for (int k = 0; k < 3; ++k) {
            v[k].x = static_cast<int16_t>(p[k].x - width * 8), v[k].y = static_cast<int16_t>(p[k].y - height * 8);
            v[k].r = static_cast<uint16_t>(random.between(0, 32768)), v[k].g = static_cast<uint16_t>(random.between(0, 32768));
            v[k].b = static_cast<uint16_t>(random.between(0, 32768)), v[k].z = static_cast<uint16_t>(random.between(first_depth, last_depth));
        }
        const int64_t area = doubled_area(v[0], v[1], v[2]);
        if (area == 0) continue;
        if (area > 0) std::swap(v[1], v[2]);
        const RasterPoint centre{width * 8, height * 8};
        const auto draw = [&](const Band<Rgb565>& band) {
            const FacingTriangle<mediump> triangle(v[0], v[1], v[2], centre, band.first_row, band.rows);
            if (triangle.shows(width)) draw_triangle<Stepping::packed, true>(triangle, band);
        };
        draw({full.data(), full_depth.data(), width, 0, height});
        for (int32_t first = 0; first < height;) {
            const int32_t rows = std::min(random.between(1, 20), height - first);
            draw({banded.data() + first * width, banded_depth.data() + first * width, width, first, rows});
            first += rows;
        }
        ASSERT_EQ(full, banded) << "triangle " << i;
        ASSERT_EQ(full_depth, banded_depth) << "triangle " << i;
    }
}

TEST(Formats, TheSwappedFrameIsTheSameWithItsBytesExchanged) {
    Random random(17);
    constexpr int32_t width = 100, height = 80;
    std::vector<uint16_t> plain(width * height), swapped(plain);
    for (int i = 0; i < 3000; ++i) {
        Point p[3];
        random_corners(random, i, width, height, p);
        ScreenVertex<mediump> v[3];
        for (int k = 0; k < 3; ++k) {
            v[k].x = static_cast<int16_t>(p[k].x - width * 8), v[k].y = static_cast<int16_t>(p[k].y - height * 8);
            v[k].r = static_cast<uint16_t>(random.between(0, 32768)), v[k].g = static_cast<uint16_t>(random.between(0, 32768));
            v[k].b = static_cast<uint16_t>(random.between(0, 32768));
        }
        const int64_t area = doubled_area(v[0], v[1], v[2]);
        if (area == 0) continue;
        if (area > 0) std::swap(v[1], v[2]);
        const RasterPoint centre{width * 8, height * 8};
        const FacingTriangle<mediump> triangle(v[0], v[1], v[2], centre, 0, height);
        if (!triangle.shows(width)) continue;
        const Band<Rgb565> band{plain.data(), nullptr, width, 0, height};
        const Band<Rgb565Swapped> swapped_band{swapped.data(), nullptr, width, 0, height};
        if (i & 1) {
            draw_triangle<Stepping::packed, false>(triangle, band);
            draw_triangle<Stepping::packed, false>(triangle, swapped_band);
        } else {
            draw_triangle<Stepping::exact, false>(triangle, band);
            draw_triangle<Stepping::exact, false>(triangle, swapped_band);
        }
    }
    for (size_t i = 0; i < plain.size(); ++i) ASSERT_EQ(swapped[i], Rgb565Swapped::swapped(plain[i]));
}

}  // namespace
}  // namespace shade16::test
