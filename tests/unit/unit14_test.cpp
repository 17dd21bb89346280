#include "shade16/num/unit14.hpp"

#include <gtest/gtest.h>

namespace shade16 {
namespace {

TEST(Unit14, HoldsPlusAndMinusOneExactly) {
    static_assert(Unit14::from_raw(Unit14::one).raw == 16384);
    static_assert(Unit14::from_raw(-Unit14::one).raw == -16384);
}

TEST(Unit14, SaturatesAtBothEnds) {
    static_assert(Unit14::from_raw(32768).raw == 32767 && Unit14::from_raw(INT32_MAX).raw == 32767);
    static_assert(Unit14::from_raw(-32769).raw == -32768 && Unit14::from_raw(INT32_MIN).raw == -32768);
    static_assert(Unit14::from_raw(-32768).raw == -32768 && Unit14::from_raw(32767).raw == 32767);
}

}  // namespace
}  // namespace shade16
