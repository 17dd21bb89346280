#include "shade16/num/literal.hpp"

#include <gtest/gtest.h>

#include "shade16/num/angle.hpp"
#include "shade16/num/q16.hpp"
#include "shade16/num/scaled.hpp"
#include "shade16/num/tier.hpp"
#include "shade16/num/unorm.hpp"

namespace shade16 {
namespace {

TEST(Literal, IsRoundedHalfUp) {
    static_assert(parse_decimal("0.5", 1, 10) == 1);
    static_assert(parse_decimal("0.49", 1, 10) == 0);
    static_assert(parse_decimal("1.25", 2, 10) == 3);
    static_assert(parse_decimal("2.4999", 2, 10) == 5);
}

TEST(Literal, HasDigitSeparators) { static_assert(parse_decimal("1'000.2'5", 100, UINT64_MAX) == 100'025); }

TEST(Literal, MayBeginOrEndWithThePoint) {
    static_assert(parse_decimal(".5", 10, 10) == 5);
    static_assert(parse_decimal("5.", 1, 10) == 5);
}

TEST(Literal, IgnoresDigitsAfterTheNinthDecimal) {
    static_assert(parse_decimal("0.123456789", 1'000'000'000, UINT64_MAX) == 123'456'789);
    static_assert(parse_decimal("0.1234567899", 1'000'000'000, UINT64_MAX) == 123'456'789);
}

TEST(Literal, ReachesTheLimit) {
    static_assert(parse_decimal("4294967295", 1, UINT32_MAX) == UINT32_MAX);
    static_assert(32767.99999_q16 == Q16::from_raw(INT32_MAX));
    static_assert((1_unorm).raw == 65535 && (0_unorm).raw == 0);
}

TEST(Literal, OfEveryTypeIsTheNearestValue) {
    static_assert((1.5_q16).raw == 98304 && (0.1_q16).raw == 6554 && (76.8_q16).raw == 5'033'165);
    static_assert((0.5_unorm).raw == 32768);
    static_assert((90_deg).turns == uint32_t{1} << 30 && (0.25_turn).turns == uint32_t{1} << 30);
    static_assert((360_deg).turns == 0 && (1_turn).turns == 0);
    static_assert((45.5_deg).turns == 542'836'144);  // 2^32 * 45.5 / 360 = 542,836,144.4
    static_assert(0.5_scaled == Scaled{0x80000000u, 0} && 10'000_scaled == Scaled(10'000));
    static_assert((0.75_levels).micro == 750'000);
}

}  // namespace
}  // namespace shade16
