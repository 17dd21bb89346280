#include "shade16/glsl/common.hpp"

#include "unit/glsl_error.hpp"

namespace shade16::glsl {
namespace {

constexpr Q16 largest = Q16::from_raw(INT32_MAX), smallest = Q16::from_raw(INT32_MIN);

TEST(GlslCommon, PartsOfANumberAreExact) {
    Worst worst("floor ..");
    over_the_range([&](Q16 x) {
        worst.add(abs(x), std::fabs(value(x)));
        worst.add(sign(x), (x.raw > 0) - (x.raw < 0));
        worst.add(floor(x), std::floor(value(x)));
        worst.add(ceil(x), std::ceil(value(x)));
        worst.add(trunc(x), std::trunc(value(x)));
        worst.add(fract(x), value(x) - std::floor(value(x)));
    });
    worst.expect(0_ulps);
    static_assert(abs(smallest) == largest && ceil(largest) == largest && floor(smallest) == smallest && ceil(smallest) == smallest);
    static_assert(floor(-1.5_q16) == -2 && ceil(-1.5_q16) == -1 && trunc(-1.5_q16) == -1 && fract(-1.25_q16) == 0.75_q16);
}

TEST(GlslCommon, ModHasTheSignOfTheDivisor) {
    AnyNumber any(3);
    for (int i = 0; i < 1'000'000; ++i) {
        const Q16 x = any(), y = any();
        if (y.raw == 0) continue;
        const int64_t rest = int64_t{x.raw} % y.raw;
        ASSERT_EQ(mod(x, y).raw, rest != 0 && (rest < 0) != (y.raw < 0) ? rest + y.raw : rest) << x.raw << " " << y.raw;
    }
    static_assert(mod(5, 3) == 2 && mod(-5, 3) == 1 && mod(5, -3) == -1 && mod(-5, -3) == -2 && mod(5, 0) == 0);
    static_assert(mod(smallest, Q16::from_raw(-1)) == 0 && mod(largest, smallest) == Q16::from_raw(-1) && mod(smallest, smallest) == 0);
}

TEST(GlslCommon, DivideIsTheNearestQuotient) {
    Worst worst("divide");
    AnyNumber any(4);
    for (int i = 0; i < 2'000'000; ++i) {
        const Q16 a = any(), b = any();
        if (b.raw != 0) worst.add(divide(a, b), value(a) / value(b));
    }
    worst.expect(divide_max_error);
    static_assert(divide(1, 3) == 0.33333333_q16 && divide(-1, 2) == -0.5_q16 && divide(smallest, 1) == smallest);
    static_assert(divide(1, 0) == largest && divide(-1, 0) == smallest && divide(0, 0) == 0 && divide(smallest, -1) == largest);
}

TEST(GlslCommon, MixAtAnyRatio) {
    Worst worst("mix");
    AnyNumber any(6);
    for (int i = 0; i < 1'000'000; ++i) {
        const Q16 a = any(), b = any(), t = i % 2 ? any() : fract(any());
        const long double exact = static_cast<long double>(a.raw) * (65536 - int64_t{t.raw}) + static_cast<long double>(b.raw) * t.raw;
        worst.add(mix(a, b, t), static_cast<double>(exact / 65536 / 65536));
        ASSERT_EQ(mix(a, b, 0), a);
        ASSERT_EQ(mix(a, b, 1), b);
    }
    worst.expect(mix_max_error);
    static_assert(mix(2, 4, 0.25_q16) == 2.5_q16 && mix(2, 4, true) == 4 && mix(smallest, largest, smallest) == smallest);
}

TEST(GlslCommon, Smoothstep) {
    Worst worst("smoothstep");
    AnyNumber any(8);
    for (int i = 0; i < 1'000'000; ++i) {
        const Q16 low = any(), high = any(), x = mix(low, high, fract(any()));
        if (low == high) continue;
        const double t = std::fmin(std::fmax((value(x) - value(low)) / (value(high) - value(low)), 0), 1);
        worst.add(smoothstep(low, high, x), t * t * (3 - 2 * t));
    }
    worst.expect(smoothstep_max_error);
    static_assert(smoothstep(0, 1, 0.5_q16) == 0.5_q16 && smoothstep(0, 1, -3) == 0 && smoothstep(0, 1, 7) == 1);
    static_assert(smoothstep(1, 0, 0.25_q16) == smoothstep(0, 1, 0.75_q16) && smoothstep(2, 2, 1) == 0 && smoothstep(2, 2, 2) == 1);
    static_assert(smoothstep(smallest, largest, 0) == 0.5_q16);
}

TEST(GlslCommon, MinMaxClampStep) {
    static_assert(min(1, 2) == 1 && max(1, 2) == 2 && clamp(5, 0, 1) == 1 && clamp(-5, 0, 1) == 0 && clamp(0.5_q16, 0, 1) == 0.5_q16);
    static_assert(step(2, 1) == 0 && step(2, 2) == 1 && step(2, 3) == 1);
}

TEST(GlslCommon, OfVectorsIsByComponent) {
    constexpr vec3 v(-1.5_q16, 0, 2.25_q16);
    static_assert(abs(v) == vec3(1.5_q16, 0, 2.25_q16) && sign(v) == vec3(-1, 0, 1) && floor(v) == vec3(-2, 0, 2));
    static_assert(ceil(v) == vec3(-1, 0, 3) && trunc(v) == vec3(-1, 0, 2) && fract(v) == vec3(0.5_q16, 0, 0.25_q16));
    static_assert(mod(v, 2) == vec3(0.5_q16, 0, 0.25_q16) && mod(v, vec3(1, 2, 3)) == vec3(0.5_q16, 0, 2.25_q16));
    static_assert(min(v, 1) == vec3(-1.5_q16, 0, 1) && max(v, vec3(0, 1, 2)) == vec3(0, 1, 2.25_q16));
    static_assert(clamp(v, -1, 1) == vec3(-1, 0, 1) && clamp(v, vec3(0), vec3(2)) == vec3(0, 0, 2));
    static_assert(mix(v, vec3(1), 1) == vec3(1) && mix(vec2(0), vec2(4, 8), vec2(0.5_q16, 0.25_q16)) == vec2(2));
    static_assert(mix(vec2(1, 2), vec2(3, 4), bvec2(false, true)) == vec2(1, 4));
    static_assert(step(0, v) == vec3(0, 1, 1) && step(vec3(3), v) == vec3(0) && smoothstep(-1, 1, v) == vec3(0, 0.5_q16, 1));
    static_assert(smoothstep(vec3(-1), vec3(1), v) == vec3(0, 0.5_q16, 1));
    static_assert(divide(v, 2) == vec3(-0.75_q16, 0, 1.125_q16) && divide(v.xz(), vec2(3, -1)) == vec2(-0.5_q16, -2.25_q16));
    static_assert(abs(ivec2(INT32_MIN, -3)) == ivec2(INT32_MAX, 3) && min(ivec2(1, 5), 3) == ivec2(1, 3) && max(ivec2(1, 5), ivec2(2, 2)) == ivec2(2, 5));
}

}  // namespace
}  // namespace shade16::glsl
