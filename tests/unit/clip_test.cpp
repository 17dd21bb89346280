#include "shade16/pipeline/clip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace shade16 {
namespace {

constexpr Outcode planes[] = {outside_near, outside_left, outside_right, outside_top, outside_bottom};

using Corner = ClipCorner<mediump>;
using Polygon = ClipPolygon<mediump>;

struct RandomTriangles {
    std::mt19937_64 random{29};

    ViewTransform transform() {
        ViewTransform t;
        t.near_depth = 1 + static_cast<int32_t>(random() >> (35 + random() % 28));  // up to 2^29
        if (random() % 4 == 0) t.orthographic_w = 1 + static_cast<int32_t>(random() >> (35 + random() % 20));
        return t;
    }
    // Coordinates as to_clip makes them: below 2^30.
    Corner corner(const ViewTransform& t, int shift) {
        const auto number = [&] { return static_cast<int32_t>(random()) >> (2 + shift); };
        Corner c;
        c.position.x = number(), c.position.y = number(), c.position.depth = number();
        c.position.w = t.is_perspective() ? c.position.depth : t.orthographic_w;
        c.r = static_cast<uint16_t>(random() & 0x7FFF), c.g = static_cast<uint16_t>(random() & 0x7FFF), c.b = 0x8000;
        return c;
    }
};

void expect_equal(const Corner& a, const Corner& b) {
    ASSERT_EQ(a.position.x, b.position.x);
    ASSERT_EQ(a.position.y, b.position.y);
    ASSERT_EQ(a.position.w, b.position.w);
    ASSERT_EQ(a.position.depth, b.position.depth);
    ASSERT_EQ(a.r, b.r);
    ASSERT_EQ(a.g, b.g);
    ASSERT_EQ(a.b, b.b);
}

TEST(Clip, ANewCornerLiesOnItsPlane) {
    RandomTriangles triangles;
    for (int i = 0; i < 300'000; ++i) {
        const ViewTransform t = triangles.transform();
        const int shift = static_cast<int>(triangles.random() % 28);
        const Corner a = triangles.corner(t, shift), b = triangles.corner(t, shift);
        const Outcode plane = planes[i % 5];
        const bool a_inside = detail::distance_inside(t, a.position, plane) >= 0, b_inside = detail::distance_inside(t, b.position, plane) >= 0;
        if (a_inside == b_inside) continue;
        const Corner c = a_inside ? detail::meet(t, a, b, plane) : detail::meet(t, b, a, plane);
        if (plane == outside_near || c.position.w > t.near_depth || !t.is_perspective()) { ASSERT_EQ(detail::distance_inside(t, c.position, plane), 0); }
        // Everything else lies between the ends.
        const auto between = [](int32_t v, int32_t p, int32_t q) { return v >= std::min(p, q) && v <= std::max(p, q); };
        ASSERT_TRUE(between(c.position.depth, a.position.depth, b.position.depth));
        ASSERT_TRUE(between(c.r, a.r, b.r) && between(c.g, a.g, b.g));
        ASSERT_EQ(c.b, 0x8000);
    }
}

TEST(Clip, ANewCornerIsWhereTheEdgeMeetsThePlane) {
    RandomTriangles triangles;
    double worst = 0;
    for (int i = 0; i < 300'000; ++i) {
        const ViewTransform t = triangles.transform();
        const Corner a = triangles.corner(t, 0), b = triangles.corner(t, 0);
        const Outcode plane = planes[i % 5];
        const double da = detail::distance_inside(t, a.position, plane), db = detail::distance_inside(t, b.position, plane);
        if (da < 0 || db >= 0) continue;
        if (plane != outside_near && (a.position.depth < t.near_depth || b.position.depth < t.near_depth)) continue;  // near comes first
        const Corner c = detail::meet(t, a, b, plane);
        const double k = da / (da - db);
        const auto error = [k](int32_t got, int32_t from, int32_t to) { return std::fabs(got - (from + (static_cast<double>(to) - from) * k)); };
        worst = std::max({worst, error(c.position.x, a.position.x, b.position.x), error(c.position.y, a.position.y, b.position.y),
                          error(c.position.depth, a.position.depth, b.position.depth)});
    }
    // Numbers are below 2^30 and their differences below 2^31; the divide errs by 2^-28 relative, and two mixes meet.
    RecordProperty("worst_units", std::to_string(worst));
    EXPECT_LE(worst, std::ldexp(reciprocal_max_error, -1) * 2 + 2);
}

TEST(Clip, ASharedEdgeGivesTheSameCornerWhicheverWayRound) {
    RandomTriangles triangles;
    for (int i = 0; i < 100'000; ++i) {
        const ViewTransform t = triangles.transform();
        const int shift = static_cast<int>(triangles.random() % 28);
        const Corner a = triangles.corner(t, shift), b = triangles.corner(t, shift), c = triangles.corner(t, shift);
        for (const Outcode plane : planes) {
            Polygon forth, back;
            forth.add(a), forth.add(b), forth.add(c);
            back.add(b), back.add(a), back.add(c);
            const auto cut_of_ab = [&](const Polygon& polygon) {
                // The corner that is none of the three and was made from a and b: the polygons' edges differ in c only.
                Polygon edge;
                edge.add(polygon.corner[0]), edge.add(polygon.corner[1]);
                return clip(t, edge, plane);
            };
            const Polygon first = cut_of_ab(forth), second = cut_of_ab(back);
            ASSERT_EQ(first.count, second.count);
            const bool a_inside = detail::distance_inside(t, a.position, plane) >= 0, b_inside = detail::distance_inside(t, b.position, plane) >= 0;
            if (a_inside != b_inside) {
                // An edge there and back: the inner end once, the cut twice.
                ASSERT_EQ(first.count, 3);
                const auto cut = [&](const Polygon& p) { return a_inside == (&p == &first) ? p.corner[1] : p.corner[0]; };
                expect_equal(cut(first), cut(second));
            }
        }
    }
}

TEST(Clip, PolygonsLieInsideAllPlanes) {
    RandomTriangles triangles;
    long drawn = 0;
    int most_corners = 0;
    for (int i = 0; i < 300'000; ++i) {
        const ViewTransform t = triangles.transform();
        Polygon polygon;
        for (int k = 0; k < 3; ++k) polygon.add(triangles.corner(t, static_cast<int>(triangles.random() % 8) * (i & 3)));
        polygon = clip(t, polygon);
        drawn += polygon.count > 0;
        most_corners = std::max(most_corners, polygon.count);
        for (int k = 0; k < polygon.count; ++k) {
            const ClipVertex& v = polygon.corner[k].position;
            ASSERT_EQ(outcode(t, v), 0) << "corner " << k << " of " << polygon.count << ": " << v.x << ' ' << v.y << ' ' << v.w << ' ' << v.depth;
            ASSERT_GT(v.w, 0);
        }
    }
    EXPECT_GE(drawn, 50'000);
    EXPECT_GE(most_corners, 6);
    EXPECT_LE(most_corners, Polygon::max_corners);
}

TEST(Clip, ATriangleInsideIsKeptAndOneOutsideIsGone) {
    ViewTransform t;
    t.near_depth = 10;
    const auto corner = [](int32_t x, int32_t y, int32_t depth) { return Corner{{x, y, depth, depth}, 1, 2, 3}; };
    Polygon inside, outside;
    inside.add(corner(0, 0, 100)), inside.add(corner(100, 0, 100)), inside.add(corner(0, -100, 100));
    const Polygon kept = clip(t, inside);
    ASSERT_EQ(kept.count, 3);
    for (int i = 0; i < 3; ++i) expect_equal(kept.corner[i], inside.corner[i]);
    outside.add(corner(0, 0, 9)), outside.add(corner(100, 0, -5)), outside.add(corner(0, -100, 0));
    EXPECT_EQ(clip(t, outside).count, 0);
}

TEST(Clip, CrossingIsTheShareOfTheInnerEnd) {
    std::mt19937_64 random{30};
    for (int i = 0; i < 300'000; ++i) {
        const uint32_t a = static_cast<uint32_t>(random()) >> (1 + random() % 31), b = (static_cast<uint32_t>(random()) >> (1 + random() % 31)) | 1;
        const double exact = static_cast<double>(a) / (static_cast<double>(a) + b);
        ASSERT_NEAR(std::ldexp(detail::crossing(a, b), -31), exact, exact * std::ldexp(reciprocal_max_error, -32) + std::ldexp(1.0, -31));
        ASSERT_LE(detail::crossing(a, b), uint32_t{1} << 31);
    }
    static_assert(detail::crossing(0, 1) == 0);
}

}  // namespace
}  // namespace shade16
