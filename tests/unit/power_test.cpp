#include "shade16/num/power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "requirements.hpp"

namespace shade16 {
namespace {

// The reference needs the 64-bit mantissa that long double has on x86.
constexpr bool has_reference = sizeof(long double) > 8;

TEST(Power, NegativeLog2IsExactTo47Bits) {
    if (!host::is_here(has_reference, "a long double that is wider than double")) GTEST_SKIP() << "long double is no wider than double here.";
    long double worst = 0;
    const auto check = [&worst](uint64_t x) {
        const long double exact = 64 - std::log2(static_cast<long double>(x));
        worst = std::fmax(worst, std::fabs(std::ldexp(static_cast<long double>(negative_log2(x)), -48) - exact));
    };
    std::mt19937_64 random{17};
    for (int i = 0; i < 100'000; ++i) check((random() >> (random() & 63)) | 1);
    for (int bit = 0; bit < 64; ++bit) check(uint64_t{1} << bit);
    check(UINT64_MAX);
    RecordProperty("worst_log2", std::to_string(static_cast<double>(std::log2(worst))));
    EXPECT_LE(worst, std::ldexp(1.0L, negative_log2_max_error_log2));
}

TEST(Power, NegativeLog2OfPowersOfTwoIsWhole) {
    static_assert(negative_log2(uint64_t{1} << 63) == uint64_t{1} << 48);
    static_assert(negative_log2(1) == uint64_t{64} << 48);
}

TEST(Power, Exp2NegativeIsExactTo32Bits) {
    if (!host::is_here(has_reference, "a long double that is wider than double")) GTEST_SKIP() << "long double is no wider than double here.";
    long double worst = 0;
    const auto check = [&worst](uint64_t t) {
        const long double exact = std::exp2(-std::ldexp(static_cast<long double>(t), -48));
        worst = std::fmax(worst, std::fabs(std::ldexp(static_cast<long double>(exp2_negative(t)), -32) - exact));
    };
    std::mt19937_64 random{18};
    for (int i = 0; i < 100'000; ++i) check(random() >> (random() & 63));
    for (uint64_t whole = 0; whole < 40; ++whole)
        for (const uint64_t near : {uint64_t{0}, uint64_t{1}, ~uint64_t{0}}) check((whole << 48) + near);
    RecordProperty("worst_log2", std::to_string(static_cast<double>(std::log2(worst))));
    EXPECT_LE(worst, std::ldexp(1.0L, exp2_negative_max_error_log2));
    static_assert(exp2_negative(0) == UINT32_MAX && exp2_negative(UINT64_MAX) == 0 && exp2_negative(uint64_t{1} << 48) == 0x80000000u);
}

TEST(Power, TimesQ16Saturates) {
    static_assert(times_q16(uint64_t{3} << 48, 65536) == uint64_t{3} << 48);
    static_assert(times_q16(uint64_t{3} << 48, 98304) == uint64_t{9} << 47);
    static_assert(times_q16(UINT64_MAX, UINT32_MAX) == UINT64_MAX && times_q16(UINT64_MAX, 65536) == UINT64_MAX && times_q16(uint64_t{1} << 63, 65536) == uint64_t{1} << 63 && times_q16(0, UINT32_MAX) == 0);
}

TEST(Power, OfAComplementIsExactTo32Bits) {
    static_assert(power_of_complement(0, 65536) == UINT32_MAX && power_of_complement(UINT32_MAX, 65536) == 1);
    static_assert(power_of_complement(UINT32_MAX, UINT32_MAX) == 0);
    if (!host::is_here(has_reference, "a long double that is wider than double")) GTEST_SKIP() << "long double is no wider than double here.";
    long double worst = 0;
    for (const uint32_t n_q16 : {65536u, 98304u, 655360u, 5033165u, 8388608u, 65536000u})
        for (uint64_t u = 1; u < uint64_t{1} << 32; u += 499'979) {
            const long double x = 1 - std::ldexp(static_cast<long double>(u), -32);
            const long double exact = std::pow(x, std::ldexp(static_cast<long double>(n_q16), -16));
            worst = std::fmax(worst, std::fabs(std::ldexp(static_cast<long double>(power_of_complement(static_cast<uint32_t>(u), n_q16)), -32) - exact));
        }
    RecordProperty("worst_log2", std::to_string(static_cast<double>(std::log2(worst))));
    EXPECT_LE(worst, std::ldexp(1.0L, power_of_complement_max_error_log2));
}

}  // namespace
}  // namespace shade16
