// Whole literals become components; a number only known at run time says how it is meant: Q16::from_int, Q16::from_raw.
// EXPECT: not a constant expression
#include "shade16/glsl.hpp"

using namespace shade16::glsl;
vec2 point(int x) { return vec2(x, 1); }
