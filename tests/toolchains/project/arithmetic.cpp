// The engine's numbers, compiled for whatever processor.
#include <shade16/glsl.hpp>

using namespace shade16;
using namespace shade16::glsl;

extern "C" int32_t length_of(int32_t x, int32_t y) { return length(vec3(Q16::from_raw(x), Q16::from_raw(y), Q16{1})).raw; }
