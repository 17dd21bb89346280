#include "shade16/num/reciprocal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>
#include <string>

namespace shade16 {
namespace {

double relative_error(uint32_t x) {
    return std::fabs(reciprocal_of_normalized(x) * std::ldexp(static_cast<double>(x), -63) - 1);
}

TEST(Reciprocal, KeepsItsBoundAllOverTheRange) {
    double worst = 0;
    for (uint64_t x = uint64_t{1} << 31; x < uint64_t{1} << 32; x += 601) worst = std::fmax(worst, relative_error(static_cast<uint32_t>(x)));
    RecordProperty("worst_log2", std::to_string(std::log2(worst)));
    EXPECT_LE(worst, std::ldexp(reciprocal_max_error, -32));
}

TEST(Reciprocal, KeepsItsBoundAtTheTableBoundaries) {
    double worst = 0;
    for (uint64_t cell = 0; cell <= 64; ++cell)
        for (int64_t near = -3000; near <= 3000; ++near) {
            const int64_t x = static_cast<int64_t>((64 + cell) << 25) + near;
            if (x >= int64_t{1} << 31 && x < int64_t{1} << 32) worst = std::fmax(worst, relative_error(static_cast<uint32_t>(x)));
        }
    EXPECT_LE(worst, std::ldexp(reciprocal_max_error, -32));
}

TEST(Reciprocal, HoldsAtBothEnds) {
    EXPECT_LE(relative_error(uint32_t{1} << 31), std::ldexp(reciprocal_max_error, -32));
    EXPECT_LE(relative_error(UINT32_MAX), std::ldexp(reciprocal_max_error, -32));
}

TEST(Reciprocal, OfAScaledNumber) {
    std::mt19937_64 random{11};
    for (int i = 0; i < 100'000; ++i) {
        const Scaled x{static_cast<uint32_t>(random()) | 0x80000000u, static_cast<int>(random() % 400) - 200}, r = reciprocal(x);
        const double product = std::ldexp(static_cast<double>(x.mantissa) * r.mantissa, x.exponent + r.exponent - 64);
        ASSERT_LE(std::fabs(product - 1), std::ldexp(reciprocal_max_error, -32));
    }
}

TEST(Reciprocal, OfZeroIsTheLargestNumber) { static_assert(reciprocal(Scaled{}) == Scaled{UINT32_MAX, INT16_MAX}); }

std::vector<uint32_t> edge_words() {
    std::vector<uint32_t> edges{0, UINT32_MAX, UINT32_MAX - 1, 3, 5, 7, 10, 100, 1000, 65535};
    for (int bit = 0; bit < 32; ++bit)
        for (const uint32_t near : {UINT32_MAX, 0u, 1u}) edges.push_back((uint32_t{1} << bit) + near);
    return edges;
}

TEST(Quotient, ByReciprocalIsTheDividersAtEveryEdge) {
    for (const uint32_t n : edge_words())
        for (const uint32_t d : edge_words())
            if (d != 0) { ASSERT_EQ(detail::quotient_by_reciprocal(n, d), n / d) << n << " / " << d; }
}

TEST(Quotient, ByReciprocalIsTheDividersAtRandom) {
    std::mt19937_64 random{12};
    for (int i = 0; i < 1'000'000; ++i) {
        const uint32_t n = static_cast<uint32_t>(random()) >> (random() & 31), d = (static_cast<uint32_t>(random()) >> (random() & 31)) | 1;
        ASSERT_EQ(detail::quotient_by_reciprocal(n, d), n / d) << n << " / " << d;
        // Just below and at a multiple, where an estimate is easily one off.
        const uint32_t multiple = n - n % d;
        ASSERT_EQ(detail::quotient_by_reciprocal(multiple, d), n / d) << multiple << " / " << d;
        if (multiple != 0) { ASSERT_EQ(detail::quotient_by_reciprocal(multiple - 1, d), n / d - 1) << multiple - 1 << " / " << d; }
    }
}

TEST(Quotient, ByZeroIsTheLargestNumber) { static_assert(quotient(0, 0) == UINT32_MAX && quotient(7, 0) == UINT32_MAX); }

TEST(Quotient, OfNegativeNumbersIsFloored) {
    static_assert(floor_quotient(-1, 1) == -1 && floor_quotient(-1, 2) == -1 && floor_quotient(-2, 2) == -1 && floor_quotient(-3, 2) == -2);
    static_assert(floor_quotient(INT32_MIN, 1) == INT32_MIN && floor_quotient(INT32_MIN, UINT32_MAX) == -1);
    static_assert(floor_quotient(7, 2) == 3 && floor_quotient(0, 9) == 0);
    std::mt19937_64 random{13};
    for (int i = 0; i < 200'000; ++i) {
        const int64_t n = static_cast<int32_t>(random()) >> (random() & 31), d = (static_cast<uint32_t>(random()) >> (random() & 31)) | 1;
        const int64_t floored = n >= 0 ? n / d : -((-n + d - 1) / d);
        ASSERT_EQ(floor_quotient(static_cast<int32_t>(n), static_cast<uint32_t>(d)), floored) << n << " / " << d;
    }
}

}  // namespace
}  // namespace shade16
