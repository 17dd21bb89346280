// A quotient has a name, divide(a, b): it costs ten times what the operators cost.
// EXPECT: vec3
#include "shade16/glsl.hpp"

using namespace shade16::glsl;
constexpr vec3 half = vec3(1, 2, 3) / 2;
