#include "shade16/num/rsqrt.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace shade16 {
namespace {

constexpr uint32_t first = uint32_t{1} << 30;

// Relative error in units of 2^-32, of a form with `fraction_bits` fraction bits.
double error_q32(uint32_t s, uint32_t got, int fraction_bits) {
    const double exact = std::ldexp(0.5, fraction_bits) / std::sqrt(std::ldexp(static_cast<double>(s), -32));
    return std::ldexp(std::fabs(got / exact - 1), 32);
}

// The worst error over a dense sweep and around every table entry. The forms need not be monotone.
template <class Form>
double worst_error(Form form, int fraction_bits) {
    double worst = 0;
    const auto check = [&](uint64_t s) {
        if (s < first || s > UINT32_MAX) return;
        const uint32_t mantissa = static_cast<uint32_t>(s);
        worst = std::fmax(worst, error_q32(mantissa, form(mantissa), fraction_bits));
    };
    for (uint64_t s = first; s <= UINT32_MAX; s += 997) check(s);
    for (uint64_t entry = 32; entry <= 128; ++entry)
        for (uint64_t near = 0; near < 2000; ++near) check((entry << 25) + near - 1000);
    check(UINT32_MAX);
    return worst;
}

TEST(Rsqrt, TableOf49KeepsItsBound) {
    const double worst = worst_error([](uint32_t s) { return rsqrt_linear<6>(s); }, 16);
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LE(worst, rsqrt_49_max_error);
}

TEST(Rsqrt, TableOf97KeepsItsBound) {
    const double worst = worst_error([](uint32_t s) { return rsqrt_linear<7>(s); }, 16);
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LE(worst, rsqrt_97_max_error);
}

TEST(Rsqrt, NewtonStepKeepsItsBound) {
    const double worst = worst_error([](uint32_t s) { return rsqrt_newton(s); }, 32);
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LE(worst, rsqrt_newton_max_error);
}

// 32768 times an entry plus the rounding constant 2^16 must stay below 2^31: normalize14 relies on it.
TEST(Rsqrt, EntriesLeaveRoomForRounding) {
    for (const uint32_t y : detail::rsqrt_table_49.y) EXPECT_LE(32768 * int64_t{y} + 65536, INT32_MAX);
    for (const uint32_t y : detail::rsqrt_table_97.y) EXPECT_LE(32768 * int64_t{y} + 65536, INT32_MAX);
}

TEST(Sqrt, OfAScaledNumberKeepsItsBound) {
    std::mt19937_64 random{34};
    double worst = 0;
    for (int i = 0; i < 500'000; ++i) {
        const Scaled x{static_cast<uint32_t>(random()) | 0x80000000u, static_cast<int>(random() % 200) - 100}, root = sqrt(x);
        ASSERT_NE(root.mantissa >> 31, 0u);
        const double exact = std::sqrt(std::ldexp(static_cast<double>(x.mantissa), x.exponent - 32));
        worst = std::fmax(worst, std::fabs(std::ldexp(static_cast<double>(root.mantissa), root.exponent - 32) / exact - 1));
    }
    RecordProperty("worst_log2", std::to_string(std::log2(worst)));
    EXPECT_LE(worst, std::ldexp(1.0, -23));
    static_assert(sqrt(Scaled{}).is_zero());
}

TEST(Isqrt, IsTheFloorOfTheRoot) {
    const auto check = [](uint64_t x) {
        const uint64_t root = isqrt(x);
        ASSERT_LE(root * root, x);
        // (root + 1)^2 > x, without leaving 64 bits.
        ASSERT_GT(2 * root + 1, x - root * root) << x;
    };
    std::mt19937_64 random{14};
    for (int i = 0; i < 50'000; ++i) {
        check(random() >> (random() & 63));
        const uint64_t root = random() >> 32;
        check(root * root);
        if (root != 0) check(root * root - 1);
    }
    for (uint64_t x = 0; x < 1000; ++x) check(x);
    static_assert(isqrt(UINT64_MAX) == UINT32_MAX && isqrt(0) == 0);
}

}  // namespace
}  // namespace shade16
