// What must hold between the results of functions, for whatever numbers: RapidCheck looks for a counterexample and
// shrinks it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "shade16/num/accumulator.hpp"
#include "shade16/num/arc.hpp"
#include "shade16/num/mat.hpp"
#include "shade16/num/rounded.hpp"
#include "shade16/num/scaled_power.hpp"
#include "shade16/num/shininess.hpp"

namespace shade16 {
namespace {

IVec3 any_vector() {
    return {*rc::gen::arbitrary<int32_t>(), *rc::gen::arbitrary<int32_t>(), *rc::gen::arbitrary<int32_t>()};
}
Scaled any_scaled() { return {*rc::gen::arbitrary<uint32_t>() | uint32_t{1} << 31, *rc::gen::inRange(-100, 100)}; }
Q16 any_q16() { return Q16::from_raw(*rc::gen::arbitrary<int32_t>()); }
Angle any_angle() { return {*rc::gen::arbitrary<uint32_t>()}; }
Normal30 any_direction() {
    IVec3 v = any_vector();
    if (v == IVec3{}) v.x = 1;
    return normalize_finely(v);
}
int64_t length_q60(IVec3 v) { return multiply(v.x, v.x) + multiply(v.y, v.y) + multiply(v.z, v.z); }

RC_GTEST_PROP(Vectors, NormalizeDependsOnTheDirectionAlone, ()) {
    const IVec3 v{*rc::gen::inRange(-(1 << 20), 1 << 20), *rc::gen::inRange(-(1 << 20), 1 << 20),
                  *rc::gen::inRange(-(1 << 20), 1 << 20)};
    const int shift = *rc::gen::inRange(0, 11);
    const IVec3 longer{v.x << shift, v.y << shift, v.z << shift};
    RC_ASSERT(normalize14<7>(v) == normalize14<7>(longer));
    RC_ASSERT(normalize30(v) == normalize30(longer));
}

RC_GTEST_PROP(Vectors, NormalizeOfAUnitVectorIsTheSame, ()) {
    const Normal30 n = any_direction(), again = normalize_finely(raw(n));
    const int64_t bound = 2 * normalize_finely_max_error.milli / 1000 + 1;
    RC_ASSERT(std::abs(int64_t{n.x.raw} - again.x.raw) <= bound && std::abs(int64_t{n.y.raw} - again.y.raw) <= bound &&
              std::abs(int64_t{n.z.raw} - again.z.raw) <= bound);
}

RC_GTEST_PROP(Vectors, DotCommutesAndCrossTurnsItsSign, ()) {
    const IVec3 v = any_vector(), w = any_vector();
    const Vec3 a{Q16::from_raw(v.x), Q16::from_raw(v.y), Q16::from_raw(v.z)},
        b{Q16::from_raw(w.x), Q16::from_raw(w.y), Q16::from_raw(w.z)};
    RC_ASSERT(dot(a, b) == dot(b, a));
    const Vec3 c = cross(a, b), d = cross(b, a);
    RC_ASSERT(std::abs(int64_t{c.x.raw} + d.x.raw) <= 1 && std::abs(int64_t{c.y.raw} + d.y.raw) <= 1 &&
              std::abs(int64_t{c.z.raw} + d.z.raw) <= 1);
    RC_ASSERT(cross(a, a) == Vec3{});
}

RC_GTEST_PROP(Vectors, RotationsKeepLengths, ()) {
    const Mat3 m = rotate_x(any_angle()) * rotate_y(any_angle()) * rotate_z(any_angle());
    const Normal30 n = any_direction();
    RC_ASSERT(std::fabs(std::ldexp(static_cast<double>(length_q60(rotate(m, raw(n)))), -60) - 1) < 2e-8);
}

RC_GTEST_PROP(Angles, SineAndCosineHaveTheirSymmetries, ()) {
    const Angle a = any_angle(), quarter{uint32_t{1} << 30};
    const SinCos here = sincos(a), opposite = sincos(a + quarter + quarter), next = sincos(a + quarter);
    RC_ASSERT(opposite.sin == -here.sin && opposite.cos == -here.cos);
    RC_ASSERT(next.sin == here.cos && next.cos == -here.sin);
    RC_ASSERT(std::fabs(std::ldexp(static_cast<double>(multiply(here.sin.raw, here.sin.raw) +
                                                       multiply(here.cos.raw, here.cos.raw)),
                                   -60) -
                        1) < 1e-8);
}

RC_GTEST_PROP(Angles, ArcsBeginAndEndWhereTheyShould, ()) {
    const Normal30 a = any_direction(), b = any_direction();
    const Arc arc(a, b), back(b, a);
    const IVec3 first = arc.at(0), last = back.at(0);
    RC_ASSERT(std::abs(int64_t{first.x} - a.x.raw) <= 2 && std::abs(int64_t{first.y} - a.y.raw) <= 2 &&
              std::abs(int64_t{first.z} - a.z.raw) <= 2);
    RC_ASSERT(std::abs(int64_t{last.x} - b.x.raw) <= 2);
    RC_ASSERT(arc.angle().turns <= uint32_t{1} << 31);
    RC_ASSERT(std::fabs(std::ldexp(static_cast<double>(length_q60(arc.at(Q30::one / 3))), -60) - 1) < 4e-8);
}

RC_GTEST_PROP(Scaled, SumsAndProductsCommuteAndReciprocalsTurnBack, ()) {
    const Scaled a = any_scaled(), b = any_scaled();
    RC_ASSERT(a + b == b + a && a * b == b * a);
    const Scaled twice = reciprocal(reciprocal(a));
    const double apart = std::ldexp(static_cast<double>(twice.mantissa), twice.exponent - a.exponent) / a.mantissa - 1;
    RC_ASSERT(std::fabs(apart) <= std::ldexp(2.0 * reciprocal_max_error, -32));
}

RC_GTEST_PROP(Scaled, RootsOfSquaresAndPowersOfOneExponent, ()) {
    const uint32_t n = *rc::gen::arbitrary<uint32_t>() >> 1;
    RC_ASSERT(rounded_root(uint64_t{n} * n) == n);
    const Scaled x = any_scaled();
    const Scaled same = power(x, 65536, 16);
    RC_ASSERT(std::fabs(std::ldexp(static_cast<double>(same.mantissa), same.exponent - x.exponent) / x.mantissa - 1) <=
              std::ldexp(scaled_power_max_error + scaled_power_max_error_each, -40));
}

RC_GTEST_PROP(Quotients, ArePutTogetherAgain, ()) {
    const uint32_t n = *rc::gen::arbitrary<uint32_t>(), d = *rc::gen::positive<uint32_t>();
    const uint32_t q = detail::quotient_by_reciprocal(n, d), rest = n - q * d;
    RC_ASSERT(rest < d);
    RC_ASSERT(uint64_t{q} * d + rest == n);
}

RC_GTEST_PROP(Q16, SumsAreOrderedAsTheirOperands, ()) {
    const Q16 a = any_q16(), b = any_q16(), c = any_q16();
    if (a <= b) RC_ASSERT(a + c <= b + c);
    RC_ASSERT(a + b == b + a && a * b == b * a);
    RC_ASSERT(a - b == -(b - a) || (a - b).raw == INT32_MIN || (b - a).raw == INT32_MIN);
}

// A larger exponent never shines more, beyond what both may err.
template <class Tier>
void falls_with_the_exponent() {
    const int32_t n = *rc::gen::inRange(65536, 65'536'000), more = *rc::gen::inRange(n, 65'536'001);
    const uint32_t u = *rc::gen::arbitrary<uint32_t>() >> (Arithmetic<Tier>::wide ? 0 : 3);
    const double a = shininess<Tier>(Q16::from_raw(n)).power(u), b = shininess<Tier>(Q16::from_raw(more)).power(u);
    const double one = Arithmetic<Tier>::wide ? 0x1p32 : 0x1p16;
    RC_ASSERT((b - a) / one * 255 <= 2e-6 * Arithmetic<Tier>::shininess_max_error.micro);
}
RC_GTEST_PROP(Shininess, FallsWithTheExponent, ()) {
    falls_with_the_exponent<lowp>();
    falls_with_the_exponent<mediump>();
    falls_with_the_exponent<highp>();
}

RC_GTEST_PROP(Accumulator, TermsAddInAnyOrder, ()) {
    const auto terms = *rc::gen::container<std::vector<uint32_t>>(rc::gen::arbitrary<uint32_t>());
    uint32_t forwards = 0, backwards = 0;
    for (auto t = terms.begin(); t != terms.end(); ++t) accumulate(forwards, *t);
    for (auto t = terms.rbegin(); t != terms.rend(); ++t) accumulate(backwards, *t);
    RC_ASSERT(forwards == backwards);
}

}  // namespace
}  // namespace shade16
