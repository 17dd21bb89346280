// EXPECT: is not a constant expression
#include "shade16/num/q16.hpp"

shade16::Q16 converted(int metres) { return metres; }
