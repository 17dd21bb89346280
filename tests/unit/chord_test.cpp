#include "shade16/pipeline/chord.hpp"

#include <gtest/gtest.h>

namespace shade16::detail {
namespace {

constexpr Normal14 normal(int32_t x, int32_t y, int32_t z) { return {Unit14::from_raw(x), Unit14::from_raw(y), Unit14::from_raw(z)}; }

TEST(Chord, is_twice_the_square_of_half_the_distance) {
    EXPECT_EQ(chord(normal(0, 0, 16384), normal(0, 0, 16384)), 0u);
    EXPECT_EQ(chord(normal(0, 0, 16384), normal(0, 16384, 0)), uint32_t{1} << 29);
    EXPECT_EQ(chord(normal(0, 0, 16384), normal(0, 0, -16384)), uint32_t{1} << 30);
}

// Found by random frames: the square of a difference above 46340 has no place beside a sign.
TEST(Chord, from_a_normal_that_is_no_unit_vector_is_defined) {
    static_assert(chord(normal(-32768, 0, 0), normal(14191, 0, 0)) == 46959u * 46959u);
}

}  // namespace
}  // namespace shade16::detail
