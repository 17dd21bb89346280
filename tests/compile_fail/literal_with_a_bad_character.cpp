// EXPECT: literal_has_a_character_that_is_neither_a_digit_nor_a_point
#include "shade16/num/q16.hpp"

using namespace shade16;
constexpr Q16 scientific = 1e3_q16;
