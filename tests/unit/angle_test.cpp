#include "shade16/num/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace shade16 {
namespace {

double error_ulp(Q30 got, double exact) { return std::fabs(got.raw - std::ldexp(exact, 30)); }

TEST(Angle, SineAndCosineKeepTheirBound) {
    double worst = 0;
    const auto check = [&worst](uint32_t turns) {
        const double radians = std::ldexp(turns, -32) * 2 * std::numbers::pi;
        const SinCos v = sincos({turns});
        worst = std::fmax(worst, std::fmax(error_ulp(v.sin, std::sin(radians)), error_ulp(v.cos, std::cos(radians))));
    };
    for (uint64_t turns = 0; turns < uint64_t{1} << 32; turns += 2999) check(static_cast<uint32_t>(turns));
    // Where the folding changes from one octant to the next.
    for (uint32_t octant = 0; octant < 8; ++octant)
        for (uint32_t near = 0; near < 2000; ++near) check((octant << 29) + near - 1000);
    RecordProperty("worst_ulp", std::to_string(worst));
    EXPECT_LE(worst, sincos_max_error.milli / 1000.0);
}

TEST(Angle, QuarterTurnsAreExact) {
    static_assert(sin(0_deg) == Q30{0} && cos(0_deg) == Q30{Q30::one});
    static_assert(sin(90_deg) == Q30{Q30::one} && cos(90_deg) == Q30{0});
    static_assert(sin(180_deg) == Q30{0} && cos(180_deg) == Q30{-Q30::one});
    static_assert(sin(270_deg) == Q30{-Q30::one} && cos(270_deg) == Q30{0});
}

TEST(Angle, SineAndCosineLieOnTheUnitCircle) {
    double worst = 0;
    for (uint64_t turns = 0; turns < uint64_t{1} << 32; turns += 5003) {
        const SinCos v = sincos({static_cast<uint32_t>(turns)});
        const double s = std::ldexp(v.sin.raw, -30), c = std::ldexp(v.cos.raw, -30);
        worst = std::fmax(worst, std::fabs(s * s + c * c - 1));
    }
    // Twice the length's error; an error of e ulp in both components moves the length by at most e sqrt(2).
    EXPECT_LE(worst, 2 * std::numbers::sqrt2 * std::ldexp(sincos_max_error.milli / 1000.0, -30));
}

TEST(Angle, WrapsAsAnglesDo) {
    static_assert(270_deg + 180_deg == 90_deg && 90_deg - 180_deg == 270_deg && -(90_deg) == 270_deg);
    static_assert((90_deg) * 5 == 90_deg && (90_deg).half() == 45_deg);
    Angle a = 350_deg;
    a += 20_deg;
    // The literals are rounded to 2^-32 turn each.
    EXPECT_LE(a.turns - (10_deg).turns + 1, 2u);
}

TEST(Angle, OppositeAnglesMirror) {
    for (uint64_t turns = 1; turns < uint64_t{1} << 32; turns += 1'000'003) {
        const SinCos v = sincos({static_cast<uint32_t>(turns)}), w = sincos(-Angle{static_cast<uint32_t>(turns)});
        ASSERT_LE(std::abs(v.sin.raw + w.sin.raw), sincos_max_error.milli / 1000.0);
        ASSERT_LE(std::abs(v.cos.raw - w.cos.raw), sincos_max_error.milli / 1000.0);
    }
}

}  // namespace
}  // namespace shade16
