// Coverage must equal 64-bit edge functions with the top-left rule on every pixel, and closed surfaces must be
// watertight: no gap, no pixel drawn twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "mock_framebuffer.hpp"

namespace shade16::test {
namespace {

struct Random {
    explicit Random(uint64_t seed) : engine(seed) {}
    std::mt19937_64 engine;
    int32_t between(int32_t low, int32_t high) {
        return low + static_cast<int32_t>(engine() % static_cast<uint64_t>(int64_t{high} - low + 1));
    }
    Point within(Point centre, int32_t reach) { return {between(centre.x - reach, centre.x + reach), between(centre.y - reach, centre.y + reach)}; }
};

// As far from the frame's centre as the guard band lets a vertex be.
Point inside_guard_band(Point p, Point centre) {
    return {std::clamp(p.x, centre.x - guard_extent, centre.x + guard_extent), std::clamp(p.y, centre.y - guard_extent, centre.y + guard_extent)};
}

struct Triangle3 {
    Point a, b, c;
};

// Kinds of triangles, over a frame whose centre is `centre`, in 1/16 pixel.
Triangle3 random_triangle(Random& random, int kind, Point centre, int32_t width, int32_t height) {
    const auto in_frame = [&] { return Point{random.between(0, width * 16), random.between(0, height * 16)}; };
    const auto triangle_about = [&](Point p, int32_t reach) { return Triangle3{random.within(p, reach), random.within(p, reach), random.within(p, reach)}; };
    Triangle3 t{};
    switch (kind) {
        case 0: t = triangle_about(in_frame(), 24); break;                        // a pixel or two
        case 1: t = triangle_about(in_frame(), 160); break;                       // ten
        case 2: t = {in_frame(), in_frame(), in_frame()}; break;                  // the frame
        case 3: t = triangle_about(in_frame(), 2 * (width + height) * 16); break;  // partially outside
        case 4: t = triangle_about(centre, guard_extent); break;                  // all over the guard band
        case 5: {                                                                 // a sliver
            const Point p = in_frame();
            const int32_t dx = random.between(-8000, 8000), dy = random.between(-8000, 8000);
            t = {{p.x - dx, p.y - dy}, {p.x + dx, p.y + dy}, {p.x + random.between(-3, 3), p.y + random.between(-3, 3)}};
            break;
        }
        case 6: {  // a long edge through the frame
            const Point p = in_frame();
            const int32_t dx = random.between(-65536, 65536), dy = random.between(-65536, 65536);
            t = {{p.x - dx, p.y - dy}, {p.x + dx, p.y + dy}, random.within(centre, guard_extent)};
            break;
        }
        case 7: {  // axis-parallel edges
            const Point p = random.within(in_frame(), 64), q = random.within(in_frame(), 640);
            t = {p, {q.x, p.y}, random.between(0, 1) ? Point{p.x, q.y} : q};
            break;
        }
        default: {  // corners on pixel centres
            const auto on_centre = [&] { const Point p = in_frame(); return Point{(p.x & ~15) + 8, (p.y & ~15) + 8}; };
            t = {on_centre(), on_centre(), on_centre()};
        }
    }
    return {inside_guard_band(t.a, centre), inside_guard_band(t.b, centre), inside_guard_band(t.c, centre)};
}
constexpr int kinds = 9;

// Draws `count` random triangles one by one, in bands of `rows(random)` rows, and checks every pixel.
template <Stepping Step, class Tier, bool Depth, class Rows>
void check_coverage(uint64_t seed, int count, int32_t width, int32_t height, Rows rows) {
    Random random(seed);
    const Point centre{width * 8, height * 8};
    for (int i = 0; i < count;) {
        for (int32_t first = 0; first < height;) {
            const int32_t band_rows = std::min(rows(random), height - first);
            MockFramebuffer<Counted565, Depth> frame(width, height, first, band_rows);
            // As many triangles as make the band's memory worth its while.
            for (int k = 0; k < 50; ++k, ++i) {
                const Triangle3 t = random_triangle(random, i % kinds, centre, width, height);
                auto a = frame.template vertex<Tier>(t.a), b = frame.template vertex<Tier>(t.b), c = frame.template vertex<Tier>(t.c);
                if constexpr (Depth) {
                    const auto depth = [&random] { return static_cast<uint16_t>(random.between(0, 3) ? random.between(first_depth, last_depth) : static_cast<int32_t>(random.between(0, 1) ? last_depth : first_depth)); };
                    a.z = depth(), b.z = depth(), c.z = depth();
                }
                frame.template draw<Step>(a, b, c);
                const ExactTriangle exact(t.a, t.b, t.c);
                ASSERT_TRUE(frame.is_written([&exact](int32_t x, int32_t y) { return exact.covers(x, y) ? 1 : 0; }))
                    << '(' << t.a.x << ", " << t.a.y << ") (" << t.b.x << ", " << t.b.y << ") (" << t.c.x << ", " << t.c.y << ") in rows " << first << " to "
                    << first + band_rows << " of " << width << " x " << height << ", depths " << a.z << ' ' << b.z << ' ' << c.z;
                frame.reset();
            }
            first += band_rows;
        }
    }
}

TEST(Coverage, EqualsEdgeFunctionsWithPackedStepping) {
    check_coverage<Stepping::packed, mediump, false>(1, 120'000, 40, 30, [](Random&) { return 30; });
}
TEST(Coverage, EqualsEdgeFunctionsWithExactStepping) {
    check_coverage<Stepping::exact, highp, false>(2, 60'000, 40, 30, [](Random&) { return 30; });
}
TEST(Coverage, EqualsEdgeFunctionsInBandsOfAnyHeight) {
    check_coverage<Stepping::packed, mediump, false>(3, 60'000, 37, 61, [](Random& random) { return random.between(1, 12); });
}
TEST(Coverage, EqualsEdgeFunctionsInTheLargestFrame) {
    check_coverage<Stepping::packed, mediump, false>(4, 1'000, max_target_px, 16, [](Random&) { return 16; });
    check_coverage<Stepping::packed, mediump, false>(5, 1'000, 16, max_target_px, [](Random& random) { return random.between(64, 512); });
}
TEST(Coverage, IsTheSameWithADepthBuffer) {
    check_coverage<Stepping::packed, mediump, true>(6, 60'000, 40, 30, [](Random&) { return 30; });
    check_coverage<Stepping::exact, highp, true>(7, 20'000, 40, 30, [](Random&) { return 30; });
}

int64_t cross(Point o, Point a, Point b) { return int64_t{a.x - o.x} * (b.y - o.y) - int64_t{a.y - o.y} * (b.x - o.x); }

// +1 where the closed polygon surely contains the pixel's centre, 0 where it surely does not, -1 on its outline.
int contains(const std::vector<Point>& polygon, int32_t x, int32_t y) {
    const Point p{x * 16 + 8, y * 16 + 8};
    int winding = 0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const int64_t side = cross(a, b, p);
        const bool in_box = p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) && p.y <= std::max(a.y, b.y);
        if (side == 0 && in_box) return -1;
        if (a.y <= p.y && b.y > p.y && side > 0) ++winding;
        if (a.y > p.y && b.y <= p.y && side < 0) --winding;
    }
    return winding != 0;
}

struct Fan {
    Point hub;
    std::vector<Point> rim;
};

// A star around a hub, its points by ascending angle; all octants have some.
Fan random_fan(Random& random, int32_t width, int32_t height, bool on_lattice) {
    const auto snapped = [&](Point p) { return on_lattice && random.between(0, 2) ? Point{(p.x & ~15) + 8, (p.y & ~15) + 8} : p; };
    Fan fan;
    fan.hub = snapped({random.between(0, width * 16), random.between(0, height * 16)});
    const int spokes = random.between(3, 24);
    const double start = random.between(0, 6283) / 1000.0;
    const double reach = random.between(8, on_lattice ? 160 : 1200);
    for (int i = 0; i < spokes; ++i) {
        const double angle = start + 2 * std::numbers::pi * (i + random.between(0, 800) / 1000.0) / spokes;
        const double radius = reach * random.between(500, 1000) / 1000;
        fan.rim.push_back(snapped({fan.hub.x + static_cast<int32_t>(std::lround(radius * std::cos(angle))),
                                   fan.hub.y + static_cast<int32_t>(std::lround(radius * std::sin(angle)))}));
    }
    return fan;
}

// Rounding to the lattice may fold a fan over; then it is no fan.
bool is_star(const Fan& fan) {
    for (size_t i = 0; i < fan.rim.size(); ++i) {
        const Point a = fan.rim[i], b = fan.rim[(i + 1) % fan.rim.size()];
        if (cross(fan.hub, a, b) <= 0) return false;
    }
    return true;
}

void check_fans(uint64_t seed, int count, bool on_lattice) {
    Random random(seed);
    constexpr int32_t width = 48, height = 40;
    int drawn = 0;
    MockFramebuffer<Counted565> frame(width, height);
    while (drawn < count) {
        const Fan fan = random_fan(random, width, height, on_lattice);
        if (!is_star(fan)) continue;
        ++drawn;
        const auto vertex = [&frame](Point p) { return frame.vertex<mediump>(p); };
        for (size_t i = 0; i < fan.rim.size(); ++i)
            frame.draw<Stepping::packed>(vertex(fan.hub), vertex(fan.rim[i]), vertex(fan.rim[(i + 1) % fan.rim.size()]));
        ASSERT_TRUE(frame.is_written([&](int32_t x, int32_t y) {
            const int inside = contains(fan.rim, x, y);
            return inside >= 0 ? inside : std::min(frame.at(x, y).writes, 1);  // on the outline the rule decides, but never twice
        })) << "hub " << fan.hub.x << ' ' << fan.hub.y << ", " << fan.rim.size() << " spokes, fan " << drawn;
        frame.reset();
    }
}

TEST(Watertight, RandomFansAreDrawnExactlyOnce) { check_fans(8, 20'000, false); }
TEST(Watertight, FansWithCornersOnPixelCentresAreDrawnExactlyOnce) { check_fans(9, 20'000, true); }

// A mesh of the whole guard band: every pixel of the frame exactly once, whatever the inner corners are.
TEST(Watertight, AWarpedGridOverTheGuardBandIsDrawnExactlyOnce) {
    Random random(10);
    constexpr int32_t width = 48, height = 40, cells = 8;
    for (int round = 0; round < 2000; ++round) {
        MockFramebuffer<Counted565> frame(width, height);
        // Some grids fill the guard band, some little more than the frame.
        const int32_t extent = round % 2 ? guard_extent : random.between(400, 2000), pitch = 2 * extent / cells, jitter = pitch / 4;
        Point grid[cells + 1][cells + 1];
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; j <= cells; ++j) {
                const bool is_inner = i > 0 && i < cells && j > 0 && j < cells;
                const Point p{width * 8 - extent + j * pitch, height * 8 - extent + i * pitch};
                grid[i][j] = is_inner ? random.within(p, jitter) : p;
            }
        const auto vertex = [&frame](Point p) { return frame.vertex<mediump>(p); };
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j) {
                const auto a = vertex(grid[i][j]), b = vertex(grid[i][j + 1]), c = vertex(grid[i + 1][j + 1]), d = vertex(grid[i + 1][j]);
                // Jitter below a quarter of the pitch keeps both halves on their side of this diagonal.
                frame.draw<Stepping::packed>(a, b, c);
                frame.draw<Stepping::packed>(a, c, d);
            }
        ASSERT_TRUE(frame.is_written([](int32_t, int32_t) { return 1; })) << "round " << round;
    }
}

}  // namespace
}  // namespace shade16::test
