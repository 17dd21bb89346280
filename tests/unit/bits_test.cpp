#include "shade16/num/bits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace shade16 {
namespace {

__extension__ typedef __int128 Wide;

// Numbers at which carries, signs and rounding change.
std::vector<int64_t> edge_numbers() {
    std::vector<int64_t> edges{0};
    for (int bit = 0; bit < 63; ++bit)
        for (const int64_t near : {-2, -1, 0, 1, 2}) {
            edges.push_back((int64_t{1} << bit) + near);
            edges.push_back(-(int64_t{1} << bit) + near);
        }
    edges.insert(edges.end(), {INT64_MAX, INT64_MAX - 1, INT64_MIN, INT64_MIN + 1});
    return edges;
}

// floor(x / 2^n + 1/2), with room to spare.
Wide rounded_half_up(Wide x, int n) { return n == 0 ? x : (x + (Wide{1} << (n - 1))) >> n; }

TEST(Bits, LeadingZerosAreCountedForEveryBit) {
    for (int bit = 0; bit < 32; ++bit) {
        EXPECT_EQ(leading_zeros(uint32_t{1} << bit), 31 - bit);
        EXPECT_EQ(leading_zeros(UINT32_MAX >> (31 - bit)), 31 - bit);
    }
    for (int bit = 0; bit < 64; ++bit) {
        EXPECT_EQ(leading_zeros(uint64_t{1} << bit), 63 - bit);
        EXPECT_EQ(leading_zeros(UINT64_MAX >> (63 - bit)), 63 - bit);
    }
}

// The builtin is undefined at 0, so a constant expression would not compile if it were reached.
TEST(Bits, LeadingZerosOfZeroAreTheWholeWord) {
    static_assert(leading_zeros(uint32_t{0}) == 32);
    static_assert(leading_zeros(uint64_t{0}) == 64);
}

TEST(Bits, MagnitudeOfTheSmallestNumberIsExact) {
    static_assert(magnitude(INT32_MIN) == uint32_t{1} << 31);
    static_assert(magnitude(INT32_MIN + 1) == static_cast<uint32_t>(INT32_MAX));
    static_assert(magnitude(int32_t{-1}) == 1);
    static_assert(magnitude(int32_t{0}) == 0);
    static_assert(magnitude(INT64_MIN) == uint64_t{1} << 63);
    static_assert(magnitude(int64_t{-7}) == 7);
}

TEST(Bits, ShiftLeftOfNegativeNumbersIsAProduct) {
    static_assert(shift_left(-3, 4) == -48);
    static_assert(shift_left(-1, 31) == INT32_MIN);
    static_assert(shift_left(INT32_MAX, 1) == -2);
    static_assert(shift_left(5, 0) == 5);
}

TEST(Bits, ShiftRightRoundsHalvesUpAtBothEnds) {
    for (const int64_t x : edge_numbers()) {
        for (int n = 0; n < 64; ++n) ASSERT_EQ(Wide{shift_right_round(x, n)}, rounded_half_up(x, n)) << x << " >> " << n;
        for (int n = 0; n < 64; ++n) {
            const uint64_t u = static_cast<uint64_t>(x);
            ASSERT_EQ(Wide{shift_right_round(u, n)}, rounded_half_up(Wide{u}, n)) << u << " >> " << n;
        }
        const int32_t narrow = static_cast<int32_t>(x);
        for (int n = 0; n < 32; ++n) ASSERT_EQ(Wide{shift_right_round(narrow, n)}, rounded_half_up(narrow, n)) << narrow << " >> " << n;
    }
}

TEST(Bits, SaturateGivesTheNearestWord) {
    static_assert(saturate(INT64_MAX) == INT32_MAX && saturate(INT64_MIN) == INT32_MIN);
    static_assert(saturate(int64_t{INT32_MAX} + 1) == INT32_MAX && saturate(int64_t{INT32_MIN} - 1) == INT32_MIN);
    static_assert(saturate(INT32_MAX) == INT32_MAX && saturate(INT32_MIN) == INT32_MIN && saturate(-5) == -5);
}

TEST(Bits, ScaleByPowerOfTwoRoundsDownwardsAndSaturatesUpwards) {
    std::mt19937_64 random{1};
    std::vector<int64_t> numbers = edge_numbers();
    for (int i = 0; i < 1000; ++i) numbers.push_back(static_cast<int64_t>(random()) >> (random() & 63));
    for (const int64_t x : numbers) {
        for (int n = -200; n <= 200; ++n) {
            Wide exact = 0;
            if (n <= 0) exact = rounded_half_up(x, std::min(-n, 100));
            else exact = n < 62 ? Wide{x} * (Wide{1} << n) : Wide{x} * (Wide{1} << 62);
            const Wide nearest = std::clamp<Wide>(exact, INT32_MIN, INT32_MAX);
            ASSERT_EQ(Wide{scale_by_power_of_two(x, n)}, nearest) << x << " * 2^" << n;
        }
    }
    static_assert(scale_by_power_of_two(1, INT32_MAX) == INT32_MAX);
    static_assert(scale_by_power_of_two(-1, INT32_MAX) == INT32_MIN);
    static_assert(scale_by_power_of_two(0, INT32_MAX) == 0);
    static_assert(scale_by_power_of_two(INT32_MAX, INT32_MIN) == 0);
}

TEST(Bits, ClampKeepsBothEnds) {
    static_assert(clamp(5, 1, 3) == 3 && clamp(-5, 1, 3) == 1 && clamp(2, 1, 3) == 2);
    static_assert(min(2u, 3u) == 2 && max(2u, 3u) == 3);
}

}  // namespace
}  // namespace shade16
