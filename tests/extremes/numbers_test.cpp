// Numbers at their ends: octave by octave from one ulp to the largest, and where other fixed-point code overflows, vanishes or traps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "shade16/num/rounded.hpp"
#include "shade16/shade16.hpp"

namespace shade16 {
namespace {

constexpr Q16 one_ulp = Q16::from_raw(1), largest = Q16::from_raw(INT32_MAX), smallest = Q16::from_raw(INT32_MIN);

TEST(NumbersAtTheirEnds, ProductsOfOneUlp) {
    static_assert(one_ulp * one_ulp == Q16{} && one_ulp * -one_ulp == Q16{} && "half up: less than half an ulp is nothing");
    static_assert(one_ulp * 0.5_q16 == one_ulp && -one_ulp * 0.5_q16 == Q16{} && "exactly half an ulp goes up");
    static_assert(one_ulp * 1 == one_ulp && one_ulp * smallest == -0.5_q16);
}

TEST(NumbersAtTheirEnds, TheSmallestNumberSaturates) {
    static_assert(-smallest == largest && smallest * smallest == largest && smallest * -1 == largest);
    static_assert(smallest + smallest == smallest && smallest - largest == smallest && largest - smallest == largest);
    static_assert(magnitude(INT32_MIN) == uint32_t{1} << 31);
}

TEST(NumbersAtTheirEnds, TheSmallestVectorHasTheDirectionOfAnyOther) {
    constexpr IVec3 ends{INT32_MIN, INT32_MIN, INT32_MIN}, ulps{-1, -1, -1}, axis{0, 0, INT32_MIN};
    static_assert(normalize30(ends) == normalize30(ulps) && normalize14<7>(ends) == normalize14<7>(ulps) && normalize14<6>(ends) == normalize14<6>(ulps));
    static_assert(normalize30(axis) == normalize30({0, 0, -1}) && normalize14<7>(axis) == normalize14<7>({0, 0, -1}));
}

// Squares of components leave Q16 above 181 and vanish below 2^-8; unit vectors must not notice.
TEST(NumbersAtTheirEnds, VectorsOfEveryOctaveHaveLengthOne) {
    const IVec3 directions[] = {{1, 0, 0}, {0, -1, 0}, {1, 1, 0}, {1, -1, 1}, {-1, -1, -1}};
    const auto length = [](IVec3 n, double one) { return std::sqrt(double{1} * n.x * n.x + double{1} * n.y * n.y + double{1} * n.z * n.z) / one; };
    // Three components off by a bound each make a length that is off by sqrt(3) of it.
    const double ulp14 = std::numbers::sqrt3 / Unit14::one, ulp30 = std::numbers::sqrt3 / Q30::one;
    for (int octave = 0; octave <= 30; ++octave)
        for (const IVec3& d : directions) {
            const IVec3 v{shift_left(d.x, octave), shift_left(d.y, octave), shift_left(d.z, octave)};
            ASSERT_NEAR(length(raw(normalize14<6>(v)), Unit14::one), 1, normalize14_small_max_error.milli / 1000.0 * ulp14) << "2^" << octave - 16;
            ASSERT_NEAR(length(raw(normalize14<7>(v)), Unit14::one), 1, normalize14_max_error.milli / 1000.0 * ulp14) << "2^" << octave - 16;
            ASSERT_NEAR(length(raw(normalize30(v)), Q30::one), 1, normalize30_max_error.milli / 1000.0 * ulp30) << "2^" << octave - 16;
            ASSERT_NEAR(length(raw(normalize_finely(v)), Q30::one), 1, normalize_finely_max_error.milli / 1000.0 * ulp30) << "2^" << octave - 16;
        }
}

double value(Scaled x) { return std::ldexp(x.mantissa, x.exponent - 32); }

TEST(NumbersAtTheirEnds, ReciprocalsOfEveryOctaveKeepTheirDigits) {
    for (int octave = 0; octave < 31; ++octave)
        for (const uint32_t raw : {(1u << octave), (1u << octave) + 1, (2u << octave) - 1}) {
            const Scaled x = Scaled::normalized(raw, -16);
            ASSERT_NEAR(value(reciprocal(x)) * value(x), 1, std::ldexp(reciprocal_max_error, -32)) << raw << " ulp";
        }
}

TEST(NumbersAtTheirEnds, RootsOfEveryOctaveKeepTheirDigits) {
    for (int octave = 0; octave < 31; ++octave)
        for (const uint32_t raw : {(1u << octave), (1u << octave) + 1, (2u << octave) - 1}) {
            const Scaled x = Scaled::normalized(raw, -16);
            ASSERT_NEAR(value(sqrt(x)) / std::sqrt(value(x)), 1, std::ldexp(1.0, -23)) << raw << " ulp";
        }
    static_assert(isqrt(0) == 0 && isqrt(1) == 1 && isqrt(UINT64_MAX) == UINT32_MAX && rounded_root(0) == 0 && rounded_root(uint64_t{1} << 62) == uint32_t{1} << 31);
}

// 1/z held as Q16 has 7 bits left at z = 512: a vertex at the edge of a frame of 2048 is 4.7 pixels off.
TEST(NumbersAtTheirEnds, DividingByAFarDistanceKeepsThePixel) {
    for (const double z : {1.0, 512.0, 16000.0, 32767.0}) {
        const Scaled distance = Scaled::normalized(static_cast<uint64_t>(z * 65536), -16), place = Scaled::normalized(1024, 0);
        ASSERT_NEAR(value(place * distance * reciprocal(distance)), 1024, 1.0 / 1024) << z;
    }
}

// Rounded down, the sum of three products is one and a half ulp low in the mean.
TEST(NumbersAtTheirEnds, RoundingHasNoBias) {
    std::mt19937_64 random{61};
    const auto any = [&random] { return Q16::from_raw(static_cast<int32_t>(random()) >> 12); };
    constexpr int count = 1'000'000;
    double product_ulp = 0, dot_ulp = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 a{any(), any(), any()}, b{any(), any(), any()};
        product_ulp += (a.x * b.x).raw - a.x.raw / 65536.0 * b.x.raw;
        dot_ulp += dot(a, b).raw - (a.x.raw / 65536.0 * b.x.raw + a.y.raw / 65536.0 * b.y.raw + a.z.raw / 65536.0 * b.z.raw);
    }
    // The mean of a million uniform errors within half an ulp strays by 0.29 / 1000: four times that.
    EXPECT_NEAR(product_ulp / count, 0, 0.0012);
    EXPECT_NEAR(dot_ulp / count, 0, 0.0012);
}

TEST(NumbersAtTheirEnds, QuotientsThatTrapElsewhere) {
    static_assert(quotient(UINT32_MAX, 0) == UINT32_MAX && rounded_quotient(UINT64_MAX, 0) == UINT32_MAX && rounded_quotient(UINT64_MAX, 1) == UINT32_MAX);
    static_assert(floor_quotient(INT32_MIN, 1) == INT32_MIN && detail::quotient_by_reciprocal(UINT32_MAX, 1) == UINT32_MAX);
    static_assert(reciprocal(Scaled{}) == Scaled{UINT32_MAX, INT16_MAX});
}

TEST(NumbersAtTheirEnds, ShiftsByMoreThanAWord) {
    static_assert(scale_by_power_of_two(-1, -64) == 0 && scale_by_power_of_two(INT64_MIN, -200) == 0 && scale_by_power_of_two(1, 200) == INT32_MAX);
    static_assert(scale_by_power_of_two(-1, 200) == INT32_MIN && scale_by_power_of_two(0, 200) == 0);
    static_assert(scaled_term(UINT32_MAX, 40) == 0 && scaled_term(1, -40) == UINT32_MAX && scaled_term(0, -40) == 0);
    static_assert(Scaled{UINT32_MAX, INT16_MAX}.to_fixed(16) == UINT64_MAX && Scaled{UINT32_MAX, INT16_MIN}.to_fixed(16) == 0);
    static_assert(leading_zeros(uint32_t{0}) == 32 && leading_zeros(uint64_t{0}) == 64);
}

TEST(NumbersAtTheirEnds, AnglesAtTheEndsOfATurn) {
    static_assert(sin(Angle{0}).raw == 0 && cos(Angle{0}).raw == Q30::one && sin(Angle{uint32_t{1} << 31}).raw == 0 && cos(Angle{uint32_t{1} << 31}).raw == -Q30::one);
    static_assert(magnitude(sin(Angle{UINT32_MAX}).raw + 2) * 1000 <= sincos_max_error.milli && magnitude(Q30::one - cos(Angle{UINT32_MAX}).raw) * 1000 <= sincos_max_error.milli);
    static_assert(Angle{UINT32_MAX} + Angle{1} == Angle{0} && -Angle{0} == Angle{0});
}

// A logarithm by table loses small numbers, and one whose index wraps loses powers of two.
TEST(NumbersAtTheirEnds, PowersOfSmallNumbersAndOfPowersOfTwo) {
    static_assert(negative_log2(uint64_t{1} << 63) == uint64_t{1} << 48 && negative_log2(1) == uint64_t{64} << 48 && negative_log2(2) == uint64_t{63} << 48);
    static_assert(power_of_complement(0, 1000u << 16) == UINT32_MAX && power_of_complement(UINT32_MAX, 1u << 16) <= 1);
    // 0.5^33.5 is not 0.35.
    constexpr uint32_t half = uint32_t{1} << 31;
    static_assert(power_of_complement(half, (33u << 16) + 32768) == 0 && power_of_complement(half, 1u << 16) == half);
}

// One step below 1: x^n by a table that was fitted in the middle is farthest off there.
template <class Tier>
double largest_step_beside_one() {
    double worst = 0;
    for (int n = 1; n <= 1000; n = n * 3 / 2 + 1) {
        const Shininess<Tier> kernel = shininess<Tier>(Q16::from_int(n));
        constexpr double one = Arithmetic<Tier>::wide ? 4294967296.0 : 65536.0, unit_of_u = Arithmetic<Tier>::wide ? 0x1p-32 : 0x1p-29;
        for (const uint32_t u : {0u, 1u, 2u, 3u})
            worst = std::max(worst, std::fabs(kernel.power(u) / one - std::pow(1 - u * unit_of_u, n)));
    }
    return worst;
}
TEST(NumbersAtTheirEnds, HighlightsBesideOneAreTheirPeak) {
    const auto share = [](Levels e) { return e.micro * 1e-6 / 255; };
    EXPECT_LE(largest_step_beside_one<lowp>(), share(Arithmetic<lowp>::shininess_max_error));
    EXPECT_LE(largest_step_beside_one<mediump>(), share(Arithmetic<mediump>::shininess_max_error));
    EXPECT_LE(largest_step_beside_one<highp>(), share(Arithmetic<highp>::shininess_max_error));
}

}  // namespace
}  // namespace shade16
