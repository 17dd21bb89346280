#include "shade16/num/shininess_shared.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "shade16/num/shininess.hpp"

namespace shade16 {
namespace {

constexpr Q16 exponents[] = {1, 1.5_q16, 10, 11.264_q16, 27.897_q16, 76.8_q16, 128, 500, 1000};

// The first u from which on (1 - u)^n is below half a 2^-32.
uint32_t lit_end(double n) { return static_cast<uint32_t>(std::fmin(-std::expm1(-23 / n) * 0x1p32, 0x1p32 - 2)); }

TEST(ShininessShared, KeepsTheShareOfHighp) {
    double worst = 0;
    for (const Q16 exponent : exponents) {
        const ShininessShared kernel = shininess<highp>(exponent);
        const double n = std::ldexp(exponent.raw, -16);
        double worst_of_exponent = 0;
        const auto check = [&](uint32_t u) {
            const double exact = std::pow(1 - std::ldexp(u, -32), n);
            worst_of_exponent = std::fmax(worst_of_exponent, 255 * std::fabs(std::ldexp(kernel.power(u), -32) - exact));
        };
        const uint32_t step = lit_end(n) / 300'000 + 1;
        for (uint64_t u = 0; u < lit_end(n); u += step) check(static_cast<uint32_t>(u));
        for (uint64_t u = 0; u < UINT32_MAX; u += 100'003) check(static_cast<uint32_t>(u));
        for (uint32_t u = 0; u < 100; ++u) check(u);
        for (uint32_t half = 1; half <= 24; ++half)  // where the mantissa wraps
            for (uint32_t near = 0; near < 100; ++near) check(0u - (uint32_t{1} << (32 - half)) + near - 50);
        RecordProperty("levels_" + std::to_string(exponent.raw / 65536), std::to_string(worst_of_exponent));
        worst = std::fmax(worst, worst_of_exponent);
    }
    EXPECT_LE(worst, Arithmetic<highp>::shininess_max_error.micro * 1e-6);
}

TEST(ShininessShared, NeverRises) {
    for (const Q16 exponent : exponents) {
        const ShininessShared kernel = shininess<highp>(exponent);
        const double n = std::ldexp(exponent.raw, -16);
        uint32_t previous = UINT32_MAX;
        const uint32_t step = lit_end(n) / 300'000 + 1;
        for (uint64_t u = 0; u < lit_end(n); u += step) {
            ASSERT_LE(kernel.power(static_cast<uint32_t>(u)), previous) << "exponent " << n << " u " << u;
            previous = kernel.power(static_cast<uint32_t>(u));
        }
    }
}

// Where one table entry, one mantissa or one octave of the power meets the next, unit by unit.
TEST(ShininessShared, NeverRisesAtSeams) {
    for (int i = 0; i < 60; ++i) {
        const ShininessShared kernel{static_cast<uint32_t>(65536 * std::pow(1000.0, i / 59.0))};
        const double n = std::ldexp(kernel.exponent, -16);
        const auto sweep = [&](double middle) {
            if (middle >= 0x1p32) return;
            uint32_t u = middle > 500 ? static_cast<uint32_t>(middle) - 500 : 0;
            for (uint32_t previous = kernel.power(u); u < UINT32_MAX && u < middle + 500; ++u) {
                ASSERT_LE(kernel.power(u), previous) << "exponent " << n << " u " << u;
                previous = kernel.power(u);
            }
        };
        for (int octave = 1; octave <= 31; ++octave) sweep(-std::expm1(-octave * std::log(2.0) / n) * 0x1p32);
        for (int entry = 1; entry <= 64; ++entry) sweep(entry * 0x1p25);
        for (int half = 1; half <= 30; ++half) sweep(0x1p32 - std::ldexp(1.0, 32 - half));
    }
}

TEST(ShininessShared, IsOneAtZeroAndZeroAtOne) {
    for (const Q16 exponent : exponents) {
        EXPECT_EQ(shininess<highp>(exponent).power(0), UINT32_MAX);
        EXPECT_EQ(shininess<highp>(exponent).power(UINT32_MAX), 0u);
    }
}

TEST(ShininessShared, IsTheSameAtRunTimeAndAtCompileTime) {
    constexpr ShininessShared compiled = shininess<highp>(27.897_q16);
    constexpr uint32_t powers[] = {compiled.power(1), compiled.power(0x01234567), compiled.power(0x80000000u), compiled.power(0xF0000000u)};
    const volatile int32_t raw = (27.897_q16).raw;
    const volatile uint32_t u[] = {1, 0x01234567, 0x80000000u, 0xF0000000u};
    const ShininessShared built = shininess<highp>(Q16::from_raw(raw));
    EXPECT_EQ(built.exponent, compiled.exponent);
    for (size_t i = 0; i < 4; ++i) EXPECT_EQ(built.power(u[i]), powers[i]);
}

TEST(ShininessShared, ExponentsAreClamped) {
    static_assert(shininess<highp>(0).exponent == 65536 && shininess<highp>(-5).exponent == 65536);
    static_assert(shininess<highp>(5000).exponent == 65'536'000 && shininess<highp>(Q16::from_raw(INT32_MAX)).exponent == 65'536'000);
    static_assert(shininess<highp>(1.5_q16).exponent == 98304);
}

}  // namespace
}  // namespace shade16
