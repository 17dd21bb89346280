#include "shade16/num/shininess_window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <string>

#include "shade16/num/shininess.hpp"

namespace shade16 {
namespace {

constexpr Q16 exponents[] = {1, 1.5_q16, 10, 11.264_q16, 27.897_q16, 76.8_q16, 128, 500, 1000};
constexpr uint32_t one_q29 = uint32_t{1} << 29;

// Farthest from (1 - u)^n, in levels, over u from 0 to past 1.
template <class Window>
double worst_levels(const Window& window, Q16 exponent) {
    const double n = std::ldexp(exponent.raw, -16);
    double worst = 0;
    const auto check = [&](uint32_t u) {
        const double exact = std::pow(std::fmax(1 - std::ldexp(u, -29), 0.0), n);
        worst = std::fmax(worst, 255 * std::fabs(std::ldexp(window.power(u), -16) - exact));
    };
    const uint32_t step = window.u_end / 30'000 + 1;
    for (uint32_t u = 0; u < window.u_end; u += step) check(u);
    for (uint32_t near = 1; near < 100; ++near) check(window.u_end - near);
    for (uint32_t near = 0; near < 100; ++near) check(window.u_end + near);
    for (uint32_t u = window.u_end; u < one_q29 + one_q29 / 8; u += 4001) check(u);
    check(2 * one_q29);
    return worst;
}

template <class Tier>
void check_bound() {
    for (const Q16 exponent : exponents) {
        const double worst = worst_levels(shininess<Tier>(exponent), exponent);
        ::testing::Test::RecordProperty(std::string(Tier::name) + "_" + std::to_string(exponent.raw / 65536), std::to_string(worst));
        EXPECT_LE(worst, Arithmetic<Tier>::shininess_max_error.micro * 1e-6) << Tier::name << " at exponent " << std::ldexp(exponent.raw, -16);
    }
}

TEST(ShininessWindow, KeepsTheShareOfLowp) { check_bound<lowp>(); }
TEST(ShininessWindow, KeepsTheShareOfMediump) { check_bound<mediump>(); }

TEST(ShininessWindow, NeverRises) {
    for (const Q16 exponent : exponents) {
        const auto window = shininess<mediump>(exponent);
        uint32_t previous = UINT32_MAX;
        const uint32_t step = window.u_end / 100'000 + 1;
        for (uint32_t u = 0; u < window.u_end + 10 * step; u += step) {
            ASSERT_LE(window.power(u), previous) << "exponent " << exponent.raw << " u " << u;
            previous = window.power(u);
        }
    }
}

template <class Tier>
void never_rises_at_seams() {
    for (int i = 0; i < 60; ++i) {
        const auto window = shininess<Tier>(Q16::from_raw(static_cast<int32_t>(65536 * std::pow(1000.0, i / 59.0))));
        const uint32_t segments = std::size(window.y) - 1;
        for (uint32_t k = 0; k <= segments; ++k) {
            const uint32_t middle = static_cast<uint32_t>(uint64_t{window.u_end} * k / segments);
            const uint32_t near = 20u << window.cell_bits;
            uint32_t u = middle > near ? middle - near : 0;
            for (uint32_t previous = window.power(u); u < middle + near; u += 1 + (window.cell_bits > 4)) {
                ASSERT_LE(window.power(u), previous) << "table " << i << " u " << u;
                previous = window.power(u);
            }
        }
    }
}
TEST(ShininessWindow, NeverRisesAtSeams) {
    never_rises_at_seams<lowp>();
    never_rises_at_seams<mediump>();
}

TEST(ShininessWindow, IsBuiltAlikeAtRunTimeAndAtCompileTime) {
    constexpr Shininess<mediump> compiled[] = {shininess<mediump>(1), shininess<mediump>(11.264_q16), shininess<mediump>(76.8_q16), shininess<mediump>(1000)};
    const volatile int32_t raw[] = {65536, (11.264_q16).raw, (76.8_q16).raw, 65'536'000};
    for (size_t i = 0; i < 4; ++i) {
        const Shininess<mediump> built = shininess<mediump>(Q16::from_raw(raw[i]));
        EXPECT_EQ(built.u_end, compiled[i].u_end);
        EXPECT_EQ(built.scale, compiled[i].scale);
        EXPECT_EQ(built.cell_bits, compiled[i].cell_bits);
        EXPECT_EQ(std::memcmp(built.y, compiled[i].y, sizeof built.y), 0);
    }
}

TEST(ShininessWindow, ExponentsAreClamped) {
    const auto same = [](Q16 given, Q16 clamped) {
        const auto a = shininess<mediump>(given), b = shininess<mediump>(clamped);
        return a.u_end == b.u_end && std::memcmp(a.y, b.y, sizeof a.y) == 0;
    };
    EXPECT_TRUE(same(0, min_shininess));
    EXPECT_TRUE(same(-5, min_shininess));
    EXPECT_TRUE(same(0.5_q16, min_shininess));
    EXPECT_TRUE(same(5000, max_shininess));
    EXPECT_TRUE(same(Q16::from_raw(INT32_MAX), max_shininess));
    EXPECT_TRUE(same(Q16::from_raw(INT32_MIN), min_shininess));
}

TEST(ShininessWindow, HasNoPowerWithoutALitSide) {
    for (const Q16 exponent : exponents) {
        const auto window = shininess<lowp>(exponent);
        EXPECT_EQ(window.power(one_q29), 0u);
        EXPECT_EQ(window.power(2 * one_q29), 0u);
        EXPECT_EQ(window.power(UINT32_MAX), 0u);
        EXPECT_GE(window.power(0), 65536u - 65536u / 255u);
    }
}

}  // namespace
}  // namespace shade16
