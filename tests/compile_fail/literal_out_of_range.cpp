// EXPECT: literal_is_out_of_range_for_its_type
#include "shade16/num/q16.hpp"

using namespace shade16;
constexpr Q16 too_far = 40000.5_q16;
