// What the proofs take as given, measured: the errors of the tables' lines, for every argument; and that the code does what the
// formulas say. Each proof has a bound that must not be proved: here is an input for which it is false.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "shade16/pipeline/light.hpp"
#include "shade16/pipeline/vertex.hpp"

namespace shade16 {
namespace {

constexpr double in_units(double error) { return error * 4294967296.0; }

double rsqrt_error(uint32_t s, double r) { return in_units(std::fabs(r * 2 * std::sqrt(std::ldexp(s, -32)) - 1)); }
double reciprocal_error(uint32_t x, double r) { return in_units(std::fabs(std::ldexp(r * x, -63) - 1)); }

// A line reads the upper bits of its argument alone, and between two of them the exact function is monotone: the ends of each
// step are the worst.
TEST(Given, TheLineOf49EntriesForEveryArgument) {
    constexpr int read_bits = 22, rest = 32 - read_bits;
    double worst = 0;
    uint32_t largest = 0;
    for (uint32_t step = 1u << (read_bits - 2); step < 1u << read_bits; ++step) {
        const uint32_t first = step << rest, last = first + (1u << rest) - 1;
        ASSERT_EQ(rsqrt_linear<6>(first), rsqrt_linear<6>(last));
        const double r = std::ldexp(rsqrt_linear<6>(first), -16);
        worst = std::max({worst, rsqrt_error(first, r), rsqrt_error(last, r)});
        largest = std::max(largest, rsqrt_linear<6>(first));
    }
    EXPECT_LE(worst, rsqrt_49_max_error);
    EXPECT_LE(largest, *std::max_element(std::begin(detail::rsqrt_table_49.y), std::end(detail::rsqrt_table_49.y)));
}

TEST(Given, TheReciprocalsLineForEveryArgument) {
    constexpr int read_bits = 23, rest = 32 - read_bits;
    double worst = 0;
    uint32_t largest = 0;
    for (uint32_t step = 1u << (read_bits - 1); step < 1u << read_bits; ++step) {
        const uint32_t first = step << rest, last = first + (1u << rest) - 1, r = detail::reciprocal_linear(first);
        ASSERT_EQ(r, detail::reciprocal_linear(last));
        worst = std::max({worst, reciprocal_error(first, r), reciprocal_error(last, r)});
        largest = std::max(largest, r);
    }
    EXPECT_LE(worst, reciprocal_linear_max_error);
    EXPECT_LE(largest, uint32_t{*std::max_element(std::begin(detail::reciprocal_table.y), std::end(detail::reciprocal_table.y))} << 16);
}

// Where the result comes near the end of its word, it stays inside.
TEST(Given, BothStepsEndBelowOne) {
    static_assert(rsqrt_newton(uint32_t{1} << 30) > 0xFFFFFF00u && reciprocal_of_normalized(uint32_t{1} << 31) > 0xFFFFFF00u);
    for (uint32_t i = 0; i < 1'000'000; ++i) {
        ASSERT_GT(rsqrt_newton((uint32_t{1} << 30) + i), 0xF0000000u) << i;
        ASSERT_GT(reciprocal_of_normalized((uint32_t{1} << 31) + i), 0xF0000000u) << i;
    }
}

TEST(Given, LoweredClaimsAreFalse) {
    const Q16 halfway = Q16::from_raw(1) * Q16::from_raw(0x8000);
    EXPECT_GT(std::fabs(std::ldexp(halfway.raw, -16) - std::ldexp(1.0, -17)), std::ldexp(q16_product_max_error.milli / 2000.0, -16));
    double newton = 0, reciprocal = 0;
    for (uint64_t s = uint64_t{1} << 30; s < uint64_t{1} << 32; s += 4999) {
        const uint32_t mantissa = static_cast<uint32_t>(s), normalized = mantissa | 0x80000000u;
        newton = std::max(newton, rsqrt_error(mantissa, std::ldexp(rsqrt_newton(mantissa), -32)));
        reciprocal = std::max(reciprocal, reciprocal_error(normalized, reciprocal_of_normalized(normalized)));
    }
    EXPECT_GT(newton, rsqrt_newton_max_error / 2.0);
    EXPECT_GT(reciprocal, reciprocal_max_error / 2.0);
}

template <class Tier>
class GivenOfLight : public testing::Test {};
using Tiers = testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(GivenOfLight, Tiers);

struct Terms {
    std::mt19937_64 random{51};

    Rgb color() { return {Unorm16::from_raw(random() & 0xFFFF), Unorm16::from_raw(random() & 0xFFFF), Unorm16::from_raw(random() & 0xFFFF)}; }
    template <bool Wide>
    uint32_t factor() { return static_cast<uint32_t>(random()) >> (Wide ? 0 : 16); }
    static double unorm(Unorm16 c) { return c.raw / 65535.0; }
};

// The code's terms and sums err no more than the formulas of the proofs, and more than half of it somewhere.
TYPED_TEST(GivenOfLight, TermsAndSumsAreThoseOfTheProofs) {
    constexpr bool wide = Arithmetic<TypeParam>::wide;
    Terms any;
    double worst_term = 0, worst_sum = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const Rgb material = any.color(), light = any.color(), glow{Unorm16::from_raw(any.random() & 0x3FFF), {}, {}};
        const uint32_t n_dot_l = any.factor<wide>() >> 2, power = any.factor<wide>() >> 2;  // a sum that needs no saturation
        const auto product = detail::make_product<TypeParam>(material, light, Scaled{0x80000000u, 1});
        Accumulator sum{};
        detail::add_term<wide>(sum, product, n_dot_l, 0);
        const double lit = Terms::unorm(material.r) * Terms::unorm(light.r), of_factor = std::ldexp(1.0, wide ? -32 : -16);
        const double diffuse = lit * n_dot_l * of_factor, specular = lit * power * of_factor;
        worst_term = std::max(worst_term, in_units(std::fabs(std::ldexp(sum.r, -24) - diffuse)));

        detail::add_term<wide>(sum, product, power, 0);
        detail::accumulate(sum, as_accumulator(glow));
        detail::add_product(sum, detail::make_product<highp>(glow, glow, Scaled{0x80000000u, 1}));
        ScreenVertex<TypeParam> vertex;
        vertex.set_color(sum);
        const double exact = diffuse + specular + Terms::unorm(glow.r) + Terms::unorm(glow.r) * Terms::unorm(glow.r);
        worst_sum = std::max(worst_sum, in_units(std::fabs(std::ldexp(vertex.r, -ScreenVertex<TypeParam>::channel_bits) - exact)));
    }
    EXPECT_LE(worst_term, light_term_max_error<TypeParam>);
    EXPECT_LE(worst_sum, color_sum_max_error<TypeParam>);
    EXPECT_GT(worst_sum, color_sum_max_error<TypeParam> / 2.0);

    // The claim of a term at half its bound fails at the largest factor, which the sum above has no room for.
    double worst_at_full = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Rgb material = any.color(), light = any.color();
        Accumulator sum{};
        const uint32_t factor = any.factor<wide>() | (wide ? 0xF0000000u : 0xF000u);
        detail::add_term<wide>(sum, detail::make_product<TypeParam>(material, light, Scaled{0x80000000u, 1}), factor, 0);
        const double exact = Terms::unorm(material.r) * Terms::unorm(light.r) * factor * std::ldexp(1.0, wide ? -32 : -16);
        worst_at_full = std::max(worst_at_full, in_units(std::fabs(std::ldexp(sum.r, -24) - exact)));
    }
    EXPECT_LE(worst_at_full, light_term_max_error<TypeParam>);
    EXPECT_GT(worst_at_full, light_term_max_error<TypeParam> / 2.0);
}

// What the sum takes of the promise is little: the rest is for N.L and the power.
TYPED_TEST(GivenOfLight, SumsTakeAFiftiethOfThePromise) {
    static_assert(uint64_t{color_sum_max_error<TypeParam>} * 255'000'000 * 50 >> 32 <= TypeParam::promise.to_exponent_128.micro);
}

}  // namespace
}  // namespace shade16
