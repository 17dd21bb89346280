#include "shade16/num/q30.hpp"

#include <gtest/gtest.h>

namespace shade16 {
namespace {

TEST(Q30, HoldsPlusAndMinusOneExactly) {
    static_assert(Q30::one == int32_t{1} << 30);
    static_assert(-Q30{Q30::one} == Q30{-Q30::one});
}

TEST(Q30, SaturatesAtBothEnds) {
    static_assert(Q30::from_raw(INT64_MAX).raw == INT32_MAX && Q30::from_raw(INT64_MIN).raw == INT32_MIN);
    static_assert(Q30::from_raw(int64_t{1} << 31).raw == INT32_MAX);
}

TEST(Q30, NegationOfMinusTwoSaturates) { static_assert(-Q30{INT32_MIN} == Q30{INT32_MAX}); }

}  // namespace
}  // namespace shade16
