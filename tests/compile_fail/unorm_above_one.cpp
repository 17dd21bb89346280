// EXPECT: literal_is_out_of_range_for_its_type
#include "shade16/num/unorm.hpp"

using namespace shade16;
constexpr Unorm16 brighter_than_white = 1.01_unorm;
