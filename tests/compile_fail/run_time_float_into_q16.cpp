// A number that is only known at run time comes in through from_raw or from_int, whose names say what happens to it.
// EXPECT: is not a constant expression
#include "shade16/num/q16.hpp"

shade16::Q16 converted(float metres) { return metres; }
