#include "shade16/num/scaled.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shade16 {
namespace {

double value_of(Scaled s) { return std::ldexp(static_cast<double>(s.mantissa), s.exponent - 32); }

TEST(Scaled, NormalizedHasItsTopBitSetAndTheValue) {
    std::mt19937_64 random{5};
    const auto check = [](uint64_t value, int exponent) {
        const Scaled s = Scaled::normalized(value, exponent);
        ASSERT_NE(s.mantissa >> 31, 0u) << value;
        const double exact = std::ldexp(static_cast<double>(value), exponent);  // errs by 2^-53 itself
        // Half a unit in the last of 32 places.
        ASSERT_LE(std::fabs(value_of(s) / exact - 1), std::ldexp(1.0, -32) * 1.001) << value;
    };
    for (int bit = 0; bit < 64; ++bit)
        for (const uint64_t near : {uint64_t{0}, uint64_t{1}, ~uint64_t{0}})
            if (const uint64_t value = (uint64_t{1} << bit) + near; value != 0) check(value, -20);
    check(UINT64_MAX, 0);
    for (int i = 0; i < 100'000; ++i) check((random() >> (random() & 63)) | 1, static_cast<int>(random() % 200) - 100);
}

TEST(Scaled, RoundingMayCarryIntoTheNextPowerOfTwo) {
    static_assert(Scaled::normalized(UINT64_MAX, 0) == Scaled{0x80000000u, 65});
    static_assert(Scaled::normalized(0x1FFFFFFFFu, 0) == Scaled{0x80000000u, 34});
}

TEST(Scaled, ZeroHasOneForm) {
    static_assert(Scaled::normalized(0, 17) == Scaled{} && Scaled(0) == Scaled{} && Scaled{}.is_zero());
    static_assert((Scaled{} * Scaled(5)).is_zero() && (Scaled(5) * Scaled{}).is_zero());
    static_assert(Scaled{}.to_fixed(0) == 0 && Scaled{}.to_fixed(100) == 0);
}

TEST(Scaled, WholeNumbersAreExact) {
    static_assert(Scaled(1) == Scaled{0x80000000u, 1} && Scaled(3) == Scaled{0xC0000000u, 2});
    static_assert(Scaled(INT32_MAX).to_fixed(0) == INT32_MAX);
}

TEST(Scaled, ProductsErrByTheirRoundingOnly) {
    std::mt19937_64 random{6};
    double worst = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const Scaled a{static_cast<uint32_t>(random()) | 0x80000000u, static_cast<int>(random() % 400) - 200};
        const Scaled b{static_cast<uint32_t>(random()) | 0x80000000u, static_cast<int>(random() % 400) - 200};
        const Scaled p = a * b;
        ASSERT_NE(p.mantissa >> 31, 0u);
        worst = std::fmax(worst, std::fabs(value_of(p) / (value_of(a) * value_of(b)) - 1));
    }
    EXPECT_LE(worst, std::ldexp(1.0, -32) * 1.001);  // the reference rounds to 2^-53
    static_assert(Scaled{UINT32_MAX, 0} * Scaled{UINT32_MAX, 0} == Scaled{UINT32_MAX - 1, 0});
    static_assert(Scaled(3) * Scaled(5) == Scaled(15));
}

TEST(Scaled, SumsErrByTheirRoundingOnly) {
    std::mt19937_64 random{35};
    double worst = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const Scaled a{static_cast<uint32_t>(random()) | 0x80000000u, static_cast<int>(random() % 80) - 40};
        const Scaled b{static_cast<uint32_t>(random()) | 0x80000000u, static_cast<int>(random() % 80) - 40};
        const Scaled sum = a + b;
        ASSERT_NE(sum.mantissa >> 31, 0u);
        ASSERT_EQ(sum, b + a);
        worst = std::fmax(worst, std::fabs(value_of(sum) / (value_of(a) + value_of(b)) - 1));
    }
    EXPECT_LE(worst, std::ldexp(1.0, -31));
    static_assert(Scaled(3) + Scaled(5) == Scaled(8) && Scaled{} + Scaled(5) == Scaled(5) && Scaled(5) + Scaled{} == Scaled(5));
}

TEST(Scaled, ToFixedRoundsDown) {
    static_assert((2.5_scaled).to_fixed(0) == 2 && (2.5_scaled).to_fixed(1) == 5 && (2.5_scaled).to_fixed(-1) == 1);
    static_assert((0.5_scaled).to_fixed(0) == 0 && (0.5_scaled).to_fixed(32) == 0x80000000u);
    static_assert(Scaled{UINT32_MAX, 0}.to_fixed(0) == 0);
    static_assert(Scaled{UINT32_MAX, -100}.to_fixed(32) == 0 && Scaled{UINT32_MAX, INT16_MIN}.to_fixed(63) == 0);
}

TEST(Scaled, ToFixedSaturatesWhereTheNumberDoesNotFit) {
    static_assert(Scaled{0x80000000u, 64}.to_fixed(0) == uint64_t{1} << 63);
    static_assert(Scaled{UINT32_MAX, 64}.to_fixed(0) == uint64_t{UINT32_MAX} << 32);
    static_assert(Scaled{0x80000000u, 65}.to_fixed(0) == UINT64_MAX);
    static_assert(Scaled{0x80000000u, INT16_MAX}.to_fixed(63) == UINT64_MAX);
}

TEST(Scaled, ExponentsSaturateAtBothEnds) {
    static_assert((Scaled{UINT32_MAX, INT16_MAX} * Scaled(4)).exponent == INT16_MAX);
    static_assert((Scaled{UINT32_MAX, INT16_MIN} * 0.25_scaled).exponent == INT16_MIN);
    static_assert(Scaled::normalized(1, 100'000).exponent == INT16_MAX && Scaled::normalized(1, -100'000).exponent == INT16_MIN);
}

}  // namespace
}  // namespace shade16
