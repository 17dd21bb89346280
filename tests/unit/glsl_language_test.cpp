// The examples that introductions to GLSL begin with, at compile time.
#include "shade16/glsl.hpp"

#include <gtest/gtest.h>

namespace shade16::glsl {
namespace {

TEST(GlslLanguage, Constructors) {
    static_assert(vec4(1, 2, 3, 4).w == 4 && vec3(0.5_q16) == vec3(0.5_q16, 0.5_q16, 0.5_q16) && vec2() == vec2(0, 0));
    constexpr vec2 uv(0.25_q16, 0.75_q16);
    static_assert(vec3(uv, 1) == vec3(0.25_q16, 0.75_q16, 1) && vec3(1, uv) == vec3(1, 0.25_q16, 0.75_q16));
    static_assert(vec4(uv, uv) == vec4(0.25_q16, 0.75_q16, 0.25_q16, 0.75_q16) && vec4(uv, 0, 1) == vec4(vec3(uv, 0), 1));
    static_assert(vec4(0, uv, 1) == vec4(0, vec3(uv, 1)) && vec4(0, 1, uv) == vec4(vec2(0, 1), uv));
    constexpr vec4 colour(0.1_q16, 0.2_q16, 0.3_q16, 1);
    static_assert(vec3(colour) == vec3(0.1_q16, 0.2_q16, 0.3_q16) && vec2(colour) == vec2(0.1_q16, 0.2_q16));
    static_assert(vec4(colour.rgb(), 0.5_q16).a() == 0.5_q16 && vec2(colour.rgb()) == colour.rg());
}

TEST(GlslLanguage, ConversionsBetweenTypes) {
    static_assert(ivec3(vec3(1.75_q16, -1.75_q16, 0)) == ivec3(1, -1, 0));  // towards 0
    static_assert(vec2(ivec2(3, -40'000)) == vec2(3, -32768));
    static_assert(bvec3(ivec3(0, 1, -1)) == bvec3(false, true, true) && bvec2(vec2(0, 0.5_q16)) == bvec2(false, true));
    static_assert(vec2(bvec2(true, false)) == vec2(1, 0) && ivec2(bvec2(true, false)) == ivec2(1, 0));
    static_assert(ivec2(vec2(-32768, Q16::from_raw(-1))) == ivec2(-32768, 0));
    static_assert(vec3(Vec3{1, 2, 3}) == vec3(1, 2, 3) && Vec3(vec3(1, 2, 3)) == Vec3{1, 2, 3});  // the engine's own
}

TEST(GlslLanguage, SwizzlesToRead) {
    constexpr vec4 v(1, 2, 3, 4);
    static_assert(v.x == 1 && v.r() == 1 && v.s() == 1 && v.w == 4 && v.a() == 4 && v.q() == 4 && v[2] == 3);
    static_assert(v.xy() == vec2(1, 2) && v.zyx() == vec3(3, 2, 1) && v.wzyx() == vec4(4, 3, 2, 1) && v.yyyy() == vec4(2));
    static_assert(v.bgra() == vec4(3, 2, 1, 4) && v.stp() == v.xyz() && v.aaa() == vec3(4) && v.qp() == vec2(4, 3));
    static_assert(vec2(5, 6).yxyx() == vec4(6, 5, 6, 5) && vec3(7, 8, 9).zz() == vec2(9) && ivec3(1, 2, 3).zx() == ivec2(3, 1));
    static_assert(bvec2(true, false).yx() == bvec2(false, true));
    static_assert(v[-1] == 1 && v[4] == 4);  // the nearest component
}

constexpr vec4 written() {
    vec4 v(1, 2, 3, 4);
    v.x = 5;
    v.g() = 6;
    v.zw() = vec2(7, 8);
    return v;
}
constexpr vec4 exchanged() {
    vec4 v(1, 2, 3, 4);
    v.xy() = v.yx();
    v.wz() = v.zw();
    return v;
}
constexpr vec3 stepped() {
    vec3 v(1, 2, 3);
    v.xz() += vec2(10, 20);
    v.xy() *= 2;
    v.rgb() -= 1;
    v.zx() *= mat2(0, 1, 1, 0);
    return v;
}
constexpr ivec3 counted() {
    ivec3 v(1, 2, 3);
    v.yx() += 5;
    v[2] = 0;
    return v;
}
TEST(GlslLanguage, SwizzlesToWrite) {
    static_assert(written() == vec4(5, 6, 7, 8) && exchanged() == vec4(2, 1, 4, 3));
    static_assert(stepped() == vec3(22, 3, 21) && counted() == ivec3(6, 7, 0));
}

constexpr bool swizzles_are_vectors() {
    vec4 v(1, 2, 3, 4), u(4, 3, 2, 1);  // with names and no const: each v.xy() below is the one that could be written
    const mat2 m(1, 2, 3, 4);
    return v.xy() + u.xy() == vec2(5) && v.xy() * 2 == vec2(2, 4) && 2 - v.xy() == vec2(1, 0) && -v.xy() == vec2(-1, -2) &&
           v.xy() == u.wz() && v.xyz() != u.xyz() && dot(v.xyz(), u.xyz()) == 16 && max(v.xy(), u.xy()) == vec2(4, 3) &&
           min(v.xy(), u.xy()) == v.xy() && clamp(v.zw(), v.xx(), v.zz()) == vec2(3) && mix(v.xy(), u.xy(), 1) == u.xy() &&
           m * v.xy() == m * vec2(1, 2) && v.xy() * m == vec2(5, 11) && length(v.xyz() - v.xyz()) == 0 && vec4(v.xy(), u.xy()).z == 4 &&
           cross(v.xyz(), v.xyz()) == vec3(0) && reflect(v.xy(), vec2(0, 1)) == vec2(1, -2) && any(lessThan(v.xy(), u.xy()));
}
TEST(GlslLanguage, FunctionsAndOperatorsTakeSwizzles) { static_assert(swizzles_are_vectors()); }

TEST(GlslLanguage, ArithmeticIsByComponent) {
    constexpr vec3 a(1, 2, 3), b(4, 5, 6);
    static_assert(a + b == vec3(5, 7, 9) && b - a == vec3(3) && a * b == vec3(4, 10, 18) && -a == vec3(-1, -2, -3));
    static_assert(a * 2 == vec3(2, 4, 6) && 0.5_q16 * a == vec3(0.5_q16, 1, 1.5_q16) && a + 1 == vec3(2, 3, 4) && 10 - a == vec3(9, 8, 7));
    static_assert(divide(b, a) == vec3(4, 2.5_q16, 2) && divide(a, 2) == vec3(0.5_q16, 1, 1.5_q16));
    static_assert(ivec2(1, 2) * 3 + ivec2(1) == ivec2(4, 7) && ivec2(INT32_MAX, INT32_MIN) + ivec2(1, -1) == ivec2(INT32_MAX, INT32_MIN));
    static_assert(ivec2(INT32_MIN) * -1 == ivec2(INT32_MAX) && -ivec2(INT32_MIN) == ivec2(INT32_MAX));
    static_assert(vec2(32767) + vec2(32767) == vec2(Q16::from_raw(INT32_MAX)));
}

TEST(GlslLanguage, Comparisons) {
    constexpr vec3 a(1, 2, 3), b(3, 2, 1);
    static_assert(a == a && a != b && lessThan(a, b) == bvec3(true, false, false) && lessThanEqual(a, b) == bvec3(true, true, false));
    static_assert(greaterThan(a, b) == bvec3(false, false, true) && greaterThanEqual(a, b) == bvec3(false, true, true));
    static_assert(equal(a, b) == bvec3(false, true, false) && notEqual(a, b) == bvec3(true, false, true));
    static_assert(any(equal(a, b)) && !all(equal(a, b)) && all(equal(a, a)) && (not(equal(a, b))) == notEqual(a, b));
}

TEST(GlslLanguage, Matrices) {
    constexpr mat2 m(1, 2, 3, 4);  // by columns
    static_assert(m[0] == vec2(1, 2) && m[1][0] == 3 && m[0][1] == 2 && m == mat2(vec2(1, 2), vec2(3, 4)) && m[7] == m[1] && m[-1] == m[0]);
    static_assert(mat3(2) == mat3(2, 0, 0, 0, 2, 0, 0, 0, 2) && mat4() == mat4(0));
    static_assert(m * vec2(1, 0) == m[0] && m * vec2(1, 1) == vec2(4, 6) && vec2(1, 1) * m == vec2(3, 7));
    static_assert(m * mat2(1) == m && mat2(1) * m == m && m * mat2(0, 1, 1, 0) == mat2(3, 4, 1, 2));
    static_assert(transpose(m) == mat2(1, 3, 2, 4) && matrixCompMult(m, m) == mat2(1, 4, 9, 16) && m + m == 2 * m && m - m == mat2(0));
    static_assert(outerProduct(vec2(1, 2), vec2(3, 4)) == mat2(3, 6, 4, 8) && -m == m * -1);

    constexpr mat4 translation(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1);
    static_assert(translation * vec4(1, 1, 1, 1) == vec4(6, 7, 8, 1) && translation * vec4(1, 1, 1, 0) == vec4(1, 1, 1, 0));
    static_assert(translation[3].xyz() == vec3(5, 6, 7) && mat3(translation) == mat3(1) && mat4(mat3(2))[3] == vec4(0, 0, 0, 1));
    static_assert((translation * translation)[3] == vec4(10, 12, 14, 1) && mat2(translation) == mat2(1));
    static_assert(translation == mat4(vec4(1, 0, 0, 0), vec4(0, 1, 0, 0), vec4(0, 0, 1, 0), vec4(vec3(5, 6, 7), 1)));
}

constexpr mat3 changed() {
    mat3 m(1);
    m[2] = vec3(1, 2, 3);
    m[0].y = 4;
    m[1].xz() = vec2(5, 6);
    m *= 2;
    m += mat3(1);
    m -= mat3(1);
    m *= mat3(1);
    return m;
}
constexpr vec3 moved() {
    vec3 v(1, 2, 3);
    v += vec3(1);
    v -= 1;
    v *= vec3(1, 2, 3);
    v *= 2;
    v *= mat3(0, 1, 0, 1, 0, 0, 0, 0, 1);
    Q16 k = 1;
    k += 2, k *= 3, k -= 1;
    return v + k;
}
TEST(GlslLanguage, CompoundAssignment) {
    static_assert(changed() == mat3(2, 8, 0, 10, 2, 12, 2, 4, 6));
    static_assert(moved() == vec3(16, 10, 26));
}

// The vertex and fragment shader of most introductions.
constexpr vec3 lit(vec3 position, vec3 normal, vec3 light, vec3 eye, vec3 colour) {
    const vec3 n = normalize(normal), l = normalize(light - position), v = normalize(eye - position), h = normalize(l + v);
    const Q16 diffuse = max(dot(n, l), 0), specular = pow(max(dot(n, h), 0), 32);
    return clamp(0.1_q16 * colour + diffuse * colour + vec3(specular), 0, 1);
}
constexpr vec4 in_clip_space(const mat4& projection, const mat4& model_view, vec3 position) {
    return projection * model_view * vec4(position, 1);
}
TEST(GlslLanguage, Shaders) {
    constexpr vec3 red(0.5_q16, 0, 0);
    static_assert(lit(vec3(0), vec3(0, 0, 2), vec3(0, 0, 5), vec3(0, 0, 9), red) == vec3(1));
    static_assert(lit(vec3(0), vec3(0, 0, 1), vec3(0, 0, -5), vec3(0, 0, 9), red) == vec3(0.05_q16, 0, 0));
    static_assert(in_clip_space(mat4(2), mat4(1), vec3(1, 2, 3)) == vec4(2, 4, 6, 2));
    static_assert(fract(sin(dot(vec2(1, 2), vec2(12.9898_q16, 78.233_q16)))) >= 0);
    static_assert(smoothstep(0.4_q16, 0.6_q16, length(vec2(0.3_q16, 0.4_q16))) == 0.5_q16);
}

}  // namespace
}  // namespace shade16::glsl

// Beside the engine's own names, as a user's program has both.
#include "shade16/shade16.hpp"
namespace beside_the_engine {
using namespace shade16;
using namespace shade16::glsl;

constexpr vec3 a(1, 2, 3);
static_assert(min(a, vec3(2)) == vec3(1, 2, 2) && max(1_q16, 2_q16) == 2 && clamp(5, 0, 3) == 3 && clamp(a, 0, 1) == vec3(1));
static_assert(dot(a, a) == 14 && dot(Vec3{1, 2, 3}, Vec3{1, 2, 3}) == 14 && cross(a, a) == vec3(0));
static_assert(sin(1_q16) == shade16::glsl::sin(1) && sin(90_deg).raw == Q30::one && normalize(a).x > 0);
static_assert(normalize(Vec3{0, 0, 2}).z.raw == Q30::one && transpose(mat2(1)) == mat2(1) && sqrt(4_q16) == 2 && mod(5, 3) == 2);
}  // namespace beside_the_engine
