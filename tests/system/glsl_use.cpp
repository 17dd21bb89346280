// The whole vocabulary included, and more or less of it used: see glsl_use.cmake.
#include "shade16/glsl.hpp"

using namespace shade16::glsl;

#if defined(NOTHING)
#elif defined(ARITHMETIC)
Q16 facing(const vec4& normal, const vec3& light) { return clamp(dot(normal.xyz(), light), 0, 1); }
#elif defined(ROOT)
Q16 root(Q16 x) { return sqrt(x); }
#elif defined(EVERYTHING)
Q16 of_numbers(Q16 x, Q16 y) {
    return abs(x) + sign(x) + floor(x) + ceil(x) + trunc(x) + fract(x) + mod(x, y) + divide(x, y) + mix(x, y, x) + step(x, y) +
           smoothstep(x, y, x) + sqrt(x) + inversesqrt(x) + exp2(x) + log2(x) + exp(x) + log(x) + pow(x, y) + radians(x) + degrees(x) +
           sin(x) + cos(x) + tan(x) + asin(x) + acos(x) + atan(x) + atan(y, x);
}
vec4 of_vectors(const mat4& m, vec4 a, vec4 b, Q16 k) {
    a.xyz() = cross(a.zyx(), b.xyz()) + normalize(b.xyz()) * length(a.xy());
    a.wz() *= distance(a, b);
    return m * (m * m) * reflect(a, b) + refract(a, b, k) * m + faceforward(a, b, normalize(a)) + clamp(mix(a, b, k), 0, 1) +
           vec4(vec4(lessThan(a, b)).xyz(), k);
}
#endif
