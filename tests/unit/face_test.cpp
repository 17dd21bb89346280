#include "shade16/pipeline/face.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shade16 {
namespace {

TEST(Face, CentreIsAnExactSum) {
    constexpr SurfacePoint centre = face_centre({-32768, 32767, 1}, {-32768, 32767, 2}, {-32768, 32767, 4});
    static_assert(centre.sum == IVec3{-98304, 98301, 7} && centre.count == 3);
}

TEST(Face, NormalOfAFaceSeenFromOutsidePointsOut) {
    static_assert(face_normal({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) == IVec3{0, 0, 1});
    static_assert(face_normal({0, 0, 0}, {0, 1, 0}, {1, 0, 0}) == IVec3{0, 0, -1});
}

TEST(Face, NormalOfNoAreaIsZero) {
    static_assert(face_normal({5, 5, 5}, {5, 5, 5}, {5, 5, 5}) == IVec3{});
    static_assert(face_normal({0, 0, 0}, {100, 200, 300}, {-200, -400, -600}) == IVec3{});
}

// The shift to 31 bits is rounded once: half a step of 2^-29 of the largest component, in each of the three.
TEST(Face, NormalsPointTheRightWayWhateverTheirSize) {
    std::mt19937 random{24};
    double worst = 0;
    for (int i = 0; i < 300'000; ++i) {
        const int shift = static_cast<int>(random() & 15);
        const auto coordinate = [&] { return static_cast<int16_t>(static_cast<int16_t>(random()) >> shift); };
        const auto corner = [&] { return Position16{coordinate(), coordinate(), coordinate()}; };
        const Position16 a = i % 7 == 0 ? Position16{-32768, 32767, -32768} : corner(), b = i % 5 == 0 ? Position16{32767, -32768, 32767} : corner(),
                         c = corner();
        const int64_t ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
        const double e[3] = {double(uy * vz - uz * vy), double(uz * vx - ux * vz), double(ux * vy - uy * vx)};
        const IVec3 n = face_normal(a, b, c);
        const double length = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]), n_length = std::sqrt(double(n.x) * n.x + double(n.y) * n.y + double(n.z) * n.z);
        if (length == 0) {
            ASSERT_EQ(n, IVec3{});
            continue;
        }
        const double dx = n.x / n_length - e[0] / length, dy = n.y / n_length - e[1] / length, dz = n.z / n_length - e[2] / length;
        worst = std::fmax(worst, std::sqrt(dx * dx + dy * dy + dz * dz));
    }
    EXPECT_LE(worst, std::sqrt(3.0) / 2 * std::ldexp(1.0, -29));
}

TEST(Face, MeanColourIsWithinThreeUnits) {
    std::mt19937 random{25};
    for (int i = 0; i < 200'000; ++i) {
        const uint32_t x = random() & 0xFFFF, y = random() & 0xFFFF, z = random() & 0xFFFF;
        const ColorFactor mean = mean_factor({Unorm16::from_raw(x), {}, {65535}}, {Unorm16::from_raw(y), {}, {65535}}, {Unorm16::from_raw(z), {}, {65535}});
        ASSERT_NEAR(mean.r, (x + y + z) / 3.0 * 65537, 3.0);
        ASSERT_EQ(mean.g, 0u);
        ASSERT_NEAR(mean.b, 4294967295.0, 3.0);
    }
}

TEST(Face, NormalUnderAStretchIsThatOfTheStretchedFace) {
    ObjectLighting<mediump> object;
    object.stretch = detail::make_stretch({1, 2, 4});
    constexpr Position16 a{0, 0, 0}, b{1000, 0, 1000}, c{0, 1000, 500};
    // Of the corners times (1, 2, 4): (1000, 0, 4000) x (0, 2000, 2000).
    const double exact[3] = {-8e6, -2e6, 2e6}, length = std::sqrt(72e12);
    const IVec3 got = raw(lighting_face_normal<all_needs>(object, a, b, c));
    EXPECT_NEAR(got.x, exact[0] / length * Unit14::one, normalize14_max_error.milli / 1000.0);
    EXPECT_NEAR(got.y, exact[1] / length * Unit14::one, normalize14_max_error.milli / 1000.0);
    EXPECT_NEAR(got.z, exact[2] / length * Unit14::one, normalize14_max_error.milli / 1000.0);
}

}  // namespace
}  // namespace shade16
