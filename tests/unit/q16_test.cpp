#include "shade16/num/q16.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace shade16 {
namespace {

constexpr Q16 smallest = Q16::from_raw(INT32_MIN), largest = Q16::from_raw(INT32_MAX), ulp = Q16::from_raw(1);

template <class T>
concept Divisible = requires(T a, T b) { a / b; };

// Quotients are explicit: see reciprocal.hpp.
static_assert(!Divisible<Q16>);

TEST(Q16, WholeLiteralsConvertByThemselves) {
    constexpr Q16 three = 3, lowest = -32768, highest = 32767;
    static_assert(three.raw == 3 * 65536 && lowest == smallest && highest.raw == 32767 * 65536);
}

TEST(Q16, AdditionSaturatesAtBothEnds) {
    static_assert(largest + ulp == largest && smallest - ulp == smallest);
    static_assert(largest + largest == largest && smallest + smallest == smallest);
    static_assert(largest - smallest == largest && smallest - largest == smallest);
    static_assert(largest + smallest == Q16::from_raw(-1));
    static_assert(1.5_q16 + 2.25_q16 == 3.75_q16 && 1.5_q16 - 2.25_q16 == -0.75_q16);
}

TEST(Q16, NegationOfTheSmallestSaturates) {
    static_assert(-smallest == largest && -largest == smallest + ulp && -Q16{} == Q16{});
}

TEST(Q16, ProductsSaturateAtBothEnds) {
    static_assert(smallest * smallest == largest && smallest * largest == smallest && largest * largest == largest);
    static_assert(smallest * Q16{-1} == largest && smallest * Q16{1} == smallest && largest * Q16{1} == largest);
}

TEST(Q16, ProductsAreRoundedHalfUp) {
    static_assert(0.5_q16 * ulp == ulp);             // 0.5 ulp goes up
    static_assert(0.5_q16 * -ulp == Q16{});          // -0.5 ulp too
    static_assert(0.25_q16 * ulp == Q16{} && 0.75_q16 * ulp == ulp);
    static_assert(1.5_q16 * -2.5_q16 == -3.75_q16);
}

TEST(Q16, ProductsMatchSixtyFourBitArithmetic) {
    const auto check = [](int32_t a, int32_t b) {
        const int64_t exact = (int64_t{a} * b + 32768) >> 16;  // at most 2^62 + 2^15
        const int64_t nearest = std::clamp<int64_t>(exact, INT32_MIN, INT32_MAX);
        ASSERT_EQ((Q16::from_raw(a) * Q16::from_raw(b)).raw, nearest) << a << " * " << b;
    };
    std::vector<int32_t> edges{0, INT32_MAX, INT32_MIN, INT32_MIN + 1};
    for (int bit = 0; bit < 31; ++bit)
        for (const int32_t near : {-1, 0, 1}) edges.insert(edges.end(), {(int32_t{1} << bit) + (bit == 30 ? 0 : near), -(int32_t{1} << bit) + near});
    for (const int32_t a : edges)
        for (const int32_t b : edges) check(a, b);
    std::mt19937_64 random{4};
    for (int i = 0; i < 1'000'000; ++i) {
        const uint64_t bits = random();
        const int shift = static_cast<int>(random() & 31);
        check(static_cast<int32_t>(bits) >> shift, static_cast<int32_t>(bits >> 32) >> (shift / 2));
    }
}

TEST(Q16, FromIntSaturates) {
    static_assert(Q16::from_int(32768) == largest && Q16::from_int(INT32_MAX) == largest);
    static_assert(Q16::from_int(-32768) == smallest && Q16::from_int(INT32_MIN) == smallest);
    static_assert(Q16::from_int(-7) == Q16{-7});
}

TEST(Q16, OrdersLikeTheNumbersItHolds) {
    static_assert(smallest < Q16{} && Q16{} < ulp && ulp < largest);
    static_assert(largest > smallest && ulp <= ulp && ulp >= ulp && !(ulp < ulp) && ulp != Q16{});
}

}  // namespace
}  // namespace shade16
