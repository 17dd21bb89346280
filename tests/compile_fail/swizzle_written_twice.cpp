// v.xx() names one place for two values.
// EXPECT: a swizzle that repeats a component is for reading only
#include "shade16/glsl.hpp"

using namespace shade16::glsl;
constexpr vec2 twice() {
    vec2 v(1, 2);
    v.xx() = vec2(3, 4);
    return v;
}
constexpr vec2 v = twice();
