// EXPECT: literal_is_out_of_range_for_its_type
#include "shade16/num/q16.hpp"

constexpr shade16::Q16 too_far = 40000;
