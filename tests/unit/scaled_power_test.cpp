#include "shade16/num/scaled_power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shade16 {
namespace {

constexpr Scaled one{uint32_t{1} << 31, 1};

double value(Scaled s) { return std::ldexp(s.mantissa, s.exponent - 32); }

struct Domain {
    const char* name;
    int32_t largest;  // exponent
    int fraction_bits, octaves;
    bool negative;
};
// What lamps ask for: d^-p of a distance squared, and a cosine to the 128th.
constexpr Domain domains[] = {{"falloff", 2 * 65536, 17, 60, true}, {"cosine", 128 * 65536, 16, 1, false}};

double allowed(double p) { return std::ldexp(scaled_power_max_error + scaled_power_max_error_each * std::fabs(p), -40); }

TEST(ScaledPower, KeepsItsDigits) {
    std::mt19937_64 random{41};
    for (const Domain& d : domains) {
        double worst = 0;  // in shares of what an exponent is allowed
        for (int i = 0; i < 300'000; ++i) {
            const uint32_t near = static_cast<uint32_t>(random() % 64);
            uint32_t mantissa = static_cast<uint32_t>(random()) | uint32_t{1} << 31;
            if (i % 8 == 0) mantissa = (uint32_t{1} << 31) + near;
            if (i % 8 == 1) mantissa = UINT32_MAX - near;
            if (i % 8 == 2) mantissa = (mantissa & 0xFC000000) + near;  // where table entries meet
            const Scaled x{mantissa, d.octaves == 1 ? 0 : static_cast<int>(random() % 61) - 30};
            const int32_t exponent = static_cast<int32_t>(random() % static_cast<uint32_t>(d.largest + 1)) * (d.negative ? -1 : 1);
            const double exact = std::pow(value(x), std::ldexp(exponent, -d.fraction_bits));
            worst = std::fmax(worst, std::fabs(value(power(x, exponent, d.fraction_bits)) / exact - 1) / allowed(std::ldexp(exponent, -d.fraction_bits)));
        }
        RecordProperty(d.name, std::to_string(worst));
        EXPECT_LE(worst, 1) << d.name;
        EXPECT_GE(worst, 0.5) << d.name << " promises less than it holds";
    }
}

TEST(ScaledPower, OfOneIsOneAndToTheFirstIsTheSame) {
    EXPECT_NEAR(value(power(one, 77 * 65536, 16)), 1, allowed(77));
    EXPECT_NEAR(value(power(Scaled(7), 65536, 16)), 7, 7 * 0x1p-28);
    EXPECT_NEAR(value(power(Scaled(7), 0, 16)), 1, 0x1p-28);
    EXPECT_NEAR(value(power(Scaled(1024), -65536, 17)), 1 / 32.0, 0x1p-33);
}

TEST(ScaledPower, OfZeroAndBeyondAllExponents) {
    EXPECT_TRUE(power(Scaled{}, 65536, 16).is_zero());
    EXPECT_EQ(power(Scaled{}, -65536, 16), (Scaled{UINT32_MAX, INT16_MAX}));
    EXPECT_EQ(power(Scaled{UINT32_MAX, INT16_MAX}, INT32_MAX, 0).exponent, INT16_MAX);
    EXPECT_EQ(power(Scaled{UINT32_MAX, INT16_MAX}, INT32_MIN, 0).exponent, INT16_MIN);
}

TEST(ScaledPower, TotalForAnyInput) {
    std::mt19937_64 random{42};
    for (int i = 0; i < 200'000; ++i) {
        const Scaled x = Scaled::normalized(random(), static_cast<int>(random() % 60000) - 30000);
        const Scaled y = power(x, static_cast<int32_t>(random()), static_cast<int>(random() % 32));
        ASSERT_TRUE(y.is_zero() || y.mantissa >> 31);
    }
}

TEST(ScaledPower, IsTheSameAtCompileTime) {
    constexpr Scaled compiled = power(Scaled(12345), -98304, 17);
    const volatile int32_t exponent = -98304;
    EXPECT_EQ(power(Scaled(12345), exponent, 17), compiled);
}

}  // namespace
}  // namespace shade16
