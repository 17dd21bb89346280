#include "shade16/glsl/exponential.hpp"

#include "unit/glsl_error.hpp"

namespace shade16::glsl {
namespace {

constexpr Q16 largest = Q16::from_raw(INT32_MAX), smallest = Q16::from_raw(INT32_MIN);

TEST(GlslExponential, SquareRoots) {
    Worst root("sqrt"), inverse("inversesqrt");
    over_the_range([&](Q16 x) {
        if (x.raw <= 0) return;
        root.add(sqrt(x), std::sqrt(value(x)));
        inverse.add(inversesqrt(x), 1 / std::sqrt(value(x)));
    }, 1'001);
    root.expect(sqrt_max_error);
    inverse.expect(inversesqrt_max_error);
    static_assert(sqrt(Q16{}) == 0 && sqrt(smallest) == 0 && sqrt(-1_q16) == 0 && sqrt(largest) == 181.01934_q16);
    static_assert(inversesqrt(0) == largest && inversesqrt(-4) == largest && inversesqrt(Q16::from_raw(1)) == 256);
}

TEST(GlslExponential, PowersOfTwoAndOfE) {
    Worst two("exp2"), e("exp");
    over_the_range([&](Q16 x) {
        two.add(exp2(x), std::exp2(value(x)));
        e.add(exp(x), std::exp(value(x)));
    });
    for (int32_t raw = -18 * 65536; raw < 16 * 65536; ++raw) {
        two.add(exp2(Q16::from_raw(raw)), std::exp2(raw / 65536.0));
        e.add(exp(Q16::from_raw(raw)), std::exp(raw / 65536.0));
    }
    two.expect(exp2_max_error);
    e.expect(exp_max_error);
    static_assert(exp2(10) == 1024 && exp2(-3) == 0.125_q16 && exp2(0) == 1 && exp2(15) == largest && exp2(-32768) == 0);
    static_assert(exp(0) == 1 && exp(32767) == largest && exp(-32768) == 0);
}

TEST(GlslExponential, Logarithms) {
    Worst two("log2"), e("log");
    over_the_range([&](Q16 x) {
        if (x.raw <= 0) return;
        two.add(log2(x), std::log2(value(x)));
        e.add(log(x), std::log(value(x)));
    });
    two.expect(log2_max_error);
    e.expect(log_max_error);
    static_assert(log2(8) == 3 && log2(Q16::from_raw(1)) == -16 && log2(0) == smallest && log2(-5) == smallest);
    static_assert(log(1) == 0 && log(0) == smallest && log(smallest) == smallest);
}

// Most powers of random numbers saturate or vanish: half of these choose the exponent so that the power is a number.
TEST(GlslExponential, Powers) {
    Worst worst("pow");
    AnyNumber any(7);
    for (int i = 0; i < 800'000; ++i) {
        const Q16 x = i % 4 == 3 ? Q16::from_raw(65'536 + static_cast<int32_t>(any.bits() % 8'192) - 4'096) : abs(any());
        if (x.raw == 0) continue;
        const double log = std::log2(value(x)), wanted = static_cast<double>(any.bits() % 32'000) / 1000 - 17;
        const Q16 y = i % 2 || x == 1 ? any() : Q16::from_raw(saturate(std::llround(std::fmin(std::fmax(wanted / log * 65536, -3e9), 3e9))));
        worst.add(pow(x, y), std::pow(value(x), value(y)));
    }
    worst.expect(pow_max_error);
}

TEST(GlslExponential, PowersAtTheirEdges) {
    static_assert(pow(2, 10) == 1024 && pow(2, -1) == 0.5_q16 && pow(9, 0.5_q16) == 3 && pow(1, 32767) == 1);
    static_assert(pow(0, 0) == 1 && pow(-2, 0) == 1 && pow(0, 2) == 0 && pow(0, -2) == largest);
    static_assert(pow(-2, 2) == 0 && pow(smallest, largest) == 0 && pow(largest, largest) == largest && pow(largest, smallest) == 0);
    static_assert(pow(Q16::from_raw(1), smallest) == largest && pow(0.5_q16, 32) == 0);
}

TEST(GlslExponential, OfVectorsIsByComponent) {
    constexpr vec3 v(4, 2, 0.25_q16);
    static_assert(sqrt(v) == vec3(2, sqrt(2_q16), 0.5_q16) && inversesqrt(v.xz()) == vec2(0.5_q16, 2));
    static_assert(exp2(v) == vec3(16, 4, exp2(0.25_q16)) && log2(v) == vec3(2, 1, -2));
    static_assert(exp(v).y == exp(2) && log(v).x == log(4) && pow(v, vec3(2)) == vec3(16, 4, 0.0625_q16));
}

}  // namespace
}  // namespace shade16::glsl
