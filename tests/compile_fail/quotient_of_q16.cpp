// The core divides in one place only, num/reciprocal.hpp, and says so.
// EXPECT: shade16::Q16
#include "shade16/num/q16.hpp"

using namespace shade16;
constexpr Q16 half = 1_q16 / 2_q16;
