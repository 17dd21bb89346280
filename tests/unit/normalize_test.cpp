#include "shade16/num/normalize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace shade16 {
namespace {

struct Worst {
    double component_ulp = 0, angle_ulp = 0;
};

// The largest error of a component and of the direction, both in ulp of the unit vector.
template <class Normalize>
Worst worst_errors(Normalize normalize_form, int fraction_bits) {
    Worst worst;
    const auto check = [&](IVec3 v) {
        const double x = v.x, y = v.y, z = v.z, length = std::sqrt(x * x + y * y + z * z), one = std::ldexp(1.0, fraction_bits);
        const double ex = x / length * one, ey = y / length * one, ez = z / length * one;
        const IVec3 n = raw(normalize_form(v));
        const double dx = n.x - ex, dy = n.y - ey, dz = n.z - ez;
        worst.component_ulp = std::max({worst.component_ulp, std::fabs(dx), std::fabs(dy), std::fabs(dz)});
        // |n x e| / |e| is the distance from the line, that is the angle.
        const double cx = dy * ez - dz * ey, cy = dz * ex - dx * ez, cz = dx * ey - dy * ex;
        worst.angle_ulp = std::fmax(worst.angle_ulp, std::sqrt(cx * cx + cy * cy + cz * cz) / one);
    };
    std::mt19937_64 random{15};
    // Log-uniform magnitudes, from one ulp to the ends of the range.
    for (int i = 0; i < 1'000'000; ++i) {
        const int shift = static_cast<int>(random() & 31);
        const auto component = [&] { return static_cast<int32_t>(random()) >> std::min(31, shift + static_cast<int>(random() % 3) * (i & 7)); };
        const IVec3 v{component(), component(), component()};
        if (v != IVec3{}) check(v);
    }
    for (int32_t x = -12; x <= 12; ++x)
        for (int32_t y = -12; y <= 12; ++y)
            for (int32_t z = -12; z <= 12; ++z)
                if ((x | y | z) != 0) check({x, y, z});
    const int32_t edges[] = {INT32_MIN, INT32_MIN + 1, -65536, -65535, -32769, -32768, -32767, -1, 0, 1, 32767, 32768, 65535, 65536, INT32_MAX};
    for (const int32_t x : edges)
        for (const int32_t y : edges)
            for (const int32_t z : edges)
                if ((x | y | z) != 0) check({x, y, z});
    return worst;
}

TEST(Normalize, SixteenBitsWithTheLargerTableKeepTheBound) {
    const Worst worst = worst_errors(normalize14<7>, 14);
    RecordProperty("worst_component_ulp", std::to_string(worst.component_ulp));
    RecordProperty("worst_angle_ulp", std::to_string(worst.angle_ulp));
    EXPECT_LE(worst.component_ulp, normalize14_max_error.milli / 1000.0);
    EXPECT_LE(worst.angle_ulp, normalize14_max_angle.milli / 1000.0);
}

TEST(Normalize, SixteenBitsWithTheSmallerTableKeepTheirBound) {
    const Worst worst = worst_errors(normalize14<6>, 14);
    RecordProperty("worst_component_ulp", std::to_string(worst.component_ulp));
    RecordProperty("worst_angle_ulp", std::to_string(worst.angle_ulp));
    EXPECT_LE(worst.component_ulp, normalize14_small_max_error.milli / 1000.0);
    EXPECT_LE(worst.angle_ulp, normalize14_max_angle.milli / 1000.0);
}

TEST(Normalize, ThirtyTwoBitsKeepTheBound) {
    const Worst worst = worst_errors(normalize30, 30);
    RecordProperty("worst_component_ulp", std::to_string(worst.component_ulp));
    RecordProperty("worst_angle_ulp", std::to_string(worst.angle_ulp));
    EXPECT_LE(worst.component_ulp, normalize30_max_error.milli / 1000.0);
    EXPECT_LE(worst.angle_ulp, normalize30_max_angle.milli / 1000.0);
}

TEST(Normalize, ASecondNewtonStepKeepsTheFinerBound) {
    const Worst worst = worst_errors(normalize_finely, 30);
    RecordProperty("worst_component_ulp", std::to_string(worst.component_ulp));
    RecordProperty("worst_angle_ulp", std::to_string(worst.angle_ulp));
    EXPECT_LE(worst.component_ulp, normalize_finely_max_error.milli / 1000.0);
    EXPECT_LE(worst.angle_ulp, normalize30_max_angle.milli / 1000.0);
}

TEST(Normalize, AZeroVectorStaysZero) {
    static_assert(normalize14<6>({}) == Normal14{} && normalize14<7>({}) == Normal14{} && normalize30({}) == Normal30{});
    static_assert(normalize(Vec3{}) == Normal30{} && normalize_finely({}) == Normal30{});
}

// Each of these has turned some implementation's vector round or made it zero.
TEST(Normalize, KeepsTheSignAtKnownTraps) {
    const auto check14 = [](IVec3 v, int32_t x, int32_t z) {
        for (const Normal14 n : {normalize14<6>(v), normalize14<7>(v)}) {
            EXPECT_NEAR(n.x.raw, x * Unit14::one, 2 * normalize14_max_error.milli / 1000.0);
            EXPECT_EQ(n.y.raw, 0);
            EXPECT_NEAR(n.z.raw, z * Unit14::one, 2 * normalize14_max_error.milli / 1000.0);
        }
    };
    check14({0, 0, 65535}, 0, 1);      // rounds to 32768, whose product with the largest entry is close to 2^31
    check14({0, 0, INT32_MAX}, 0, 1);
    check14({-1, 0, 0}, -1, 0);        // the magnitude of -1 is not 0
    check14({INT32_MIN, 0, 0}, -1, 0);
    check14({1, 0, 0}, 1, 0);
    EXPECT_NEAR(normalize30({INT32_MIN, 0, 0}).x.raw, -Q30::one, normalize30_max_error.milli / 1000.0);
    EXPECT_NEAR(normalize30({-1, 0, 0}).x.raw, -Q30::one, normalize30_max_error.milli / 1000.0);
    EXPECT_NEAR(normalize30({0, 0, INT32_MAX}).z.raw, Q30::one, normalize30_max_error.milli / 1000.0);
}

TEST(Normalize, TheShiftTurnsNoVector) {
    for (int shift = 0; shift < 24; ++shift) {
        EXPECT_EQ(normalize30({3 << shift, -(5 << shift), 7 << shift}), normalize30({3, -5, 7}));
        EXPECT_EQ(normalize14<7>({3 << shift, -(5 << shift), 7 << shift}), normalize14<7>({3, -5, 7}));
    }
}

}  // namespace
}  // namespace shade16
