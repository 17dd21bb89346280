#include "shade16/glsl.hpp"

#include <numbers>

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"

namespace shade16::bounds {
namespace {

double value(Q16 x) { return x.raw / 65536.0; }

/// In ulp of Q16, of an exact value that is first brought into range.
double ulps(Q16 got, double exact) {
    return std::fabs(got.raw - std::fmin(std::fmax(exact * 65536, INT32_MIN), INT32_MAX));
}

Entry entry(const char* name, const char* header, Ulps bound, const char* functions = nullptr) {
    return {.name = std::string("glsl::") + name,
            .header = std::string("glsl/") + header,
            .functions = std::string("glsl::") + (functions ? functions : name),
            .unit = "ulp of Q16",
            .bound = in_ulps(bound)};
}

/// A function of one argument, over all of them: 2^32.
template <class F, class Exact>
void add_one(Entries& to, Entry e, F f, Exact exact) {
    to.add(std::move(e), [f, exact](uint64_t word) {
        const Q16 x = Q16::from_raw(static_cast<int32_t>(word));
        return ulps(f(x), exact(value(x)));
    });
}

/// Beside a pole half a unit and a share of the value.
double tangent_error(uint64_t word) {
    const Q16 x = Q16::from_raw(static_cast<int32_t>(word));
    const double exact = std::tan(value(x)), error = ulps(glsl::tan(x), exact);
    if (std::fabs(exact) < 256) return error;
    return std::fmax(0, error - std::ldexp(std::fabs(exact) * 65536, glsl::tan_max_relative_error_log2));
}

double pow_error(Dice& dice) {
    const Q16 x = dice.below(3) == 0 ? Q16::from_raw(65536 + dice.integer(-3000, 3000))  // to a large power
                                     : Q16::from_raw(static_cast<int32_t>(std::max<uint32_t>(dice.word() >> 1, 1)));
    const double wanted = dice.uniform(dice.below(2) != 0 ? 13.5 : -17, 15), log = std::log2(value(x));
    const Q16 y = dice.below(2) != 0 || log == 0
                      ? dice.q16()
                      : Q16::from_raw(saturate(std::llround(std::fmin(std::fmax(wanted / log * 65536, -3e9), 3e9))));
    return ulps(glsl::pow(x, y), std::pow(value(x), value(y)));
}

double mix_error(Dice& dice) {
    const Q16 a = dice.q16(), b = dice.q16(), t = dice.below(2) != 0 ? dice.q16() : glsl::fract(dice.q16());
    const Wide exact = Wide{a.raw} * (65536 - int64_t{t.raw}) + Wide{b.raw} * t.raw;
    return ulps(glsl::mix(a, b, t), static_cast<double>(exact) / 4294967296.0);
}
double smoothstep_error(Dice& dice) {
    const Q16 low = dice.q16(), high = dice.q16(),
              x = dice.below(4) == 0 ? dice.q16() : glsl::mix(low, high, glsl::fract(dice.q16()));
    if (low == high) return ulps(glsl::smoothstep(low, high, x), x < low ? 0 : 1);
    const double t = std::clamp((value(x) - value(low)) / (value(high) - value(low)), 0.0, 1.0);
    return ulps(glsl::smoothstep(low, high, x), t * t * (3 - 2 * t));
}
double mod_error(Dice& dice) {
    const Q16 x = dice.q16(), y = dice.q16();
    if (y.raw == 0) return std::fabs(value(glsl::mod(x, y)));
    const int64_t rest = int64_t{x.raw} % y.raw;
    return Differences()(glsl::mod(x, y).raw, rest != 0 && (rest < 0) != (y.raw < 0) ? rest + y.raw : rest);
}
double divide_error(Dice& dice) {
    const Q16 a = dice.q16(), b = dice.q16();
    const double without = a.raw == 0 ? 0 : a.raw < 0 ? -1e9 : 1e9;  // a divisor
    return ulps(glsl::divide(a, b), b.raw == 0 ? without : value(a) / value(b));
}
double parts_error(Q16 x) {
    const int64_t v = x.raw, below = v >> 16 << 16, above = below + (v != below ? 65536 : 0), largest = INT32_MAX;
    Differences worst;
    worst(glsl::abs(x).raw, std::min(v < 0 ? -v : v, largest))(glsl::sign(x).raw, v > 0 ? 65536 : v < 0 ? -65536 : 0);
    return worst(glsl::floor(x).raw, below)(glsl::ceil(x).raw, std::min(above, largest))(
        glsl::trunc(x).raw, v < 0 ? above : below)(glsl::fract(x).raw, v - below);
}

glsl::vec3 any_vector(Dice& dice) {
    const Vec3 v = dice.vec3();
    return {v.x, v.y, v.z};
}
long double exact_dot(const glsl::vec3& a, const glsl::vec3& b) {
    long double sum = 0;
    for (int i = 0; i < 3; ++i) sum += static_cast<long double>(a[i].raw) * b[i].raw;
    return sum / 65536 / 65536;
}
double length_error(Dice& dice) {
    const glsl::vec3 a = any_vector(dice), b = any_vector(dice);
    long double between = 0;
    for (int i = 0; i < 3; ++i) between += std::pow(static_cast<long double>(a[i].raw) - b[i].raw, 2.0L);
    return larger(ulps(glsl::length(a), static_cast<double>(std::sqrt(exact_dot(a, a)))),
                  ulps(glsl::distance(a, b), static_cast<double>(std::sqrt(between) / 65536)));
}
double dot_error(Dice& dice) {
    const glsl::vec3 a = any_vector(dice), b = any_vector(dice);
    return ulps(glsl::dot(a, b), static_cast<double>(exact_dot(a, b)));
}
double normalize_error(Dice& dice) {
    const glsl::vec3 a = any_vector(dice), n = glsl::normalize(a);
    const long double length = std::sqrt(exact_dot(a, a));
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        worst = larger(worst, ulps(n[i], length == 0 ? 0 : static_cast<double>(a[i].raw / length / 65536)));
    return worst;
}

}  // namespace

void add_glsl(Entries& to) {
    constexpr double degree = std::numbers::pi / 180;
    using namespace glsl;
    to.add(entry("floor, ceil, ..", "common.hpp", {0}, "abs glsl::sign glsl::floor glsl::ceil glsl::trunc glsl::fract"),
           [](uint64_t word) { return parts_error(Q16::from_raw(static_cast<int32_t>(word))); });
    add_one(
        to, entry("sqrt", "exponential.hpp", sqrt_max_error), [](Q16 x) { return glsl::sqrt(x); },
        [](double x) { return x > 0 ? std::sqrt(x) : 0; });
    add_one(
        to, entry("inversesqrt", "exponential.hpp", inversesqrt_max_error), [](Q16 x) { return inversesqrt(x); },
        [](double x) { return x > 0 ? 1 / std::sqrt(x) : 1e9; });
    add_one(
        to, entry("exp2", "exponential.hpp", exp2_max_error), [](Q16 x) { return exp2(x); },
        [](double x) { return std::exp2(x); });
    add_one(
        to, entry("exp", "exponential.hpp", exp_max_error), [](Q16 x) { return exp(x); },
        [](double x) { return std::exp(x); });
    add_one(
        to, entry("log2", "exponential.hpp", log2_max_error), [](Q16 x) { return log2(x); },
        [](double x) { return x > 0 ? std::log2(x) : -1e9; });
    add_one(
        to, entry("log", "exponential.hpp", log_max_error), [](Q16 x) { return log(x); },
        [](double x) { return x > 0 ? std::log(x) : -1e9; });
    add_one(
        to, entry("radians", "trigonometry.hpp", radians_max_error), [](Q16 x) { return radians(x); },
        [](double x) { return x * degree; });
    add_one(
        to, entry("degrees", "trigonometry.hpp", degrees_max_error), [](Q16 x) { return degrees(x); },
        [](double x) { return x / degree; });
    add_one(
        to, entry("sin", "trigonometry.hpp", sin_max_error), [](Q16 x) { return glsl::sin(x); },
        [](double x) { return std::sin(x); });
    add_one(
        to, entry("cos", "trigonometry.hpp", cos_max_error), [](Q16 x) { return glsl::cos(x); },
        [](double x) { return std::cos(x); });
    to.add(entry("tan", "trigonometry.hpp", tan_max_error), tangent_error);
    add_one(
        to, entry("asin", "trigonometry.hpp", asin_max_error), [](Q16 x) { return asin(x); },
        [](double x) { return std::asin(std::clamp(x, -1.0, 1.0)); });
    add_one(
        to, entry("acos", "trigonometry.hpp", acos_max_error), [](Q16 x) { return acos(x); },
        [](double x) { return std::acos(std::clamp(x, -1.0, 1.0)); });
    add_one(
        to, entry("atan", "trigonometry.hpp", atan_max_error), [](Q16 x) { return atan(x); },
        [](double x) { return std::atan(x); });
    to.add_random(entry("atan(y, x)", "trigonometry.hpp", atan_max_error, "atan"), [](Dice& dice) {
        const Q16 y = dice.q16(), x = dice.q16();
        return ulps(atan(y, x), std::atan2(value(y), value(x)));
    });
    to.add_random(entry("pow", "exponential.hpp", pow_max_error), pow_error);
    to.add_random(entry("mod", "common.hpp", {0}), mod_error);
    to.add_random(entry("divide", "common.hpp", divide_max_error), divide_error);
    to.add_random(entry("mix", "common.hpp", mix_max_error), mix_error);
    to.add_random(entry("smoothstep", "common.hpp", smoothstep_max_error), smoothstep_error);
    to.add_random(entry("dot", "matrix.hpp", glsl::dot_max_error), dot_error);
    to.add_random(entry("length, distance", "geometric.hpp", length_max_error, "length glsl::distance"), length_error);
    to.add_random(entry("normalize", "geometric.hpp", normalize_max_error), normalize_error);
}

}  // namespace shade16::bounds
