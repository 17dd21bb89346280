// Tables are made of integers: each entry lies within half a unit of what its formula says.
#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "shade16/num/arc.hpp"
#include "shade16/num/scaled_power.hpp"
#include "shade16/num/shininess.hpp"

namespace shade16::bounds {
namespace {

using Real = long double;

double off(Real entry, Real exact) { return static_cast<double>(std::fabs(entry - exact)); }

/// Lowered by a sixteenth of the second difference, whose ends take their neighbours'; in whole numbers.
template <class F>
Real lowered(F whole, uint64_t i, uint64_t last) {
    const uint64_t k = std::clamp<uint64_t>(i, 1, last - 1);
    return static_cast<Real>(whole(i) - (whole(k - 1) - 2 * whole(k) + whole(k + 1)) / 16);
}

template <int Bits>
double rsqrt_entry(uint64_t i) {
    const auto& table = detail::rsqrt_table<Bits>();
    const Real x = static_cast<Real>(table.first + i), f = 32768 / std::sqrt(std::ldexp(x, -Bits));
    return off(table.y[i], std::fmin(f - f * 3 / (64 * x * x), 65533.0L));
}
double reciprocal_entry(uint64_t i) {
    const Real a = static_cast<Real>(64 + i), exact = 65536 * 64 / a;
    return off(detail::reciprocal_table.y[i], std::fmin(exact - exact / (8 * a * a), 65535.0L));
}
double log_entry(uint64_t i) {
    const auto whole = [](uint64_t k) -> int64_t {
        if (k == 0) return std::llround(std::ldexp(1 / std::log(2.0L), 31));
        const Real x = static_cast<Real>(k) / 128;
        return static_cast<int64_t>(std::ldexp(-std::log2(1 - x) / x, 31));
    };
    return off(detail::log_table.y[i], lowered(whole, i, 64));
}
double exp_entry(uint64_t i) {
    const auto whole = [](uint64_t k) -> int64_t {
        return std::llround(std::ldexp(std::exp2(-static_cast<Real>(k) / 128), 32));
    };
    if (i == 128) return off(detail::exp_table.y[i], detail::exp_table.y[0] / 2);  // where octaves meet
    return off(detail::exp_table.y[i], std::fmin(lowered(whole, i, 128), 4294967295.0L));
}
double middle_log_entry(uint64_t i) {
    const Real inverse = std::floor(std::ldexp(64.0L, 32) / static_cast<Real>(65 + 2 * i));
    return std::fmax(off(detail::middle_log_table.inverse[i], inverse),
                     off(detail::middle_log_table.log[i], std::ldexp(-std::log2(std::ldexp(inverse, -32)), 32)));
}
double middle_exp_entry(uint64_t i) {
    return off(detail::middle_exp_table.y[i], std::ldexp(std::exp2(static_cast<Real>(2 * i + 1) / 64), 31));
}
double divisor_entry(uint64_t i) {
    const Real k = static_cast<Real>(5 - i);  // sin: 2k (2k + 1), cos: 2k (2k - 1)
    return std::fmax(off(detail::sine_reciprocals[i], 4294967296.0L / (2 * k * (2 * k + 1))),
                     off(detail::cosine_reciprocals[i], 4294967296.0L / (2 * k * (2 * k - 1))));
}
/// The largest whose square does not exceed the root before, in integers: long double has no digit to spare.
double root_of_half_entry(uint64_t i) {
    const uint64_t before = i == 0 ? uint64_t{1} << 63 : detail::roots_of_half.y[i],
                   root = detail::roots_of_half.y[i + 1];
    return mulhi(root, root) <= before && mulhi(root + 1, root + 1) > before ? 0 : 1;
}

/// A window's entries for 64 exponents, in units of 2^-16.
template <class Tier>
double window_entry(uint64_t i) {
    const auto raw = static_cast<int32_t>(65536 * std::pow(1000.0, static_cast<double>(i) / 63));
    const auto window = shininess<Tier>(Q16::from_raw(raw));
    const Real n = static_cast<Real>(raw) / 65536;
    constexpr uint64_t segments = std::size(decltype(window.y){}) - 1;
    double worst = 0;
    const auto exact = [&](uint64_t k) {
        const uint64_t u = static_cast<uint64_t>(window.u_end) * k / segments;
        return std::pow(1 - std::ldexp(static_cast<Real>(u), -29), n);
    };
    const auto curvature = [&](uint64_t k) { return exact(k - 1) - 2 * exact(k) + exact(k + 1); };
    for (uint64_t k = 0; k <= segments; ++k) {
        const Real bend = k == 0 ? 2 * curvature(1) - curvature(2) : curvature(std::min(k, segments - 1));
        const Real wanted = std::fmin(65536 * (exact(k) - std::clamp(bend / 16, 0.0L, exact(k) / 2)), 65535.0L);
        worst = larger(worst, off(window.y[k], wanted));
    }
    return worst;
}

}  // namespace

void add_tables(Entries& to) {
    const auto add = [&to](const char* name, const char* header, uint64_t count, double bound,
                           double (*error)(uint64_t)) {
        to.add({.name = name,
                .header = header,
                .functions = "",
                .unit = "units",
                .bound = bound,
                .inputs = {0, count - 1}},
               error);
    };
    add("table of 49 for rsqrt", "num/rsqrt.hpp", 49, in_ulps(table_max_error), rsqrt_entry<6>);
    add("table of 97 for rsqrt", "num/rsqrt.hpp", 97, in_ulps(table_max_error), rsqrt_entry<7>);
    add("table for the reciprocal", "num/reciprocal.hpp", 65, in_ulps(table_max_error), reciprocal_entry);
    add("table for the logarithm", "num/shininess_shared.hpp", 65, in_ulps(detail::shared_table_max_error), log_entry);
    add("table for the power of two", "num/shininess_shared.hpp", 129, in_ulps(detail::shared_table_max_error),
        exp_entry);
    add("middles for the logarithm", "num/scaled_power.hpp", 32, in_ulps(table_max_error), middle_log_entry);
    add("middles for the power of two", "num/scaled_power.hpp", 32, in_ulps(table_max_error), middle_exp_entry);
    add("divisors of the sine and cosine", "num/angle.hpp", 5, in_ulps(table_max_error), divisor_entry);
    add("roots of a half", "num/power.hpp", 48, 0, root_of_half_entry);
    add("windows of lowp", "num/shininess_window.hpp", 64, in_ulps(table_max_error), window_entry<lowp>);
    add("windows of mediump", "num/shininess_window.hpp", 64, in_ulps(table_max_error), window_entry<mediump>);
}

}  // namespace shade16::bounds
