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

/// Lowered by a sixteenth of the second difference, whose ends take their neighbours'.
template <class F>
Real lowered(F exact, uint64_t i, uint64_t last) {
    const uint64_t k = std::clamp<uint64_t>(i, 1, last - 1);
    return exact(i) - (exact(k - 1) - 2 * exact(k) + exact(k + 1)) / 16;
}

template <int Bits>
double rsqrt_entry(uint64_t i) {
    const auto& table = detail::rsqrt_table<Bits>;
    const Real x = static_cast<Real>(table.first + i), f = 32768 / std::sqrt(std::ldexp(x, -Bits));
    return off(table.y[i], std::fmin(f - f * 3 / (64 * x * x), 65533.0L));
}
double reciprocal_entry(uint64_t i) {
    const Real a = static_cast<Real>(64 + i), exact = 65536 * 64 / a;
    return off(detail::reciprocal_table.y[i], std::fmin(exact - exact / (8 * a * a), 65535.0L));
}
double log_entry(uint64_t i) {
    const auto exact = [](uint64_t k) {
        return std::ldexp(
            k == 0 ? 1 / std::log(2.0L) : -std::log2(1 - static_cast<Real>(k) / 128) * 128 / static_cast<Real>(k), 31);
    };
    return off(detail::log_table.y[i], lowered(exact, i, 64));
}
double exp_entry(uint64_t i) {
    const auto exact = [](uint64_t k) { return std::ldexp(std::exp2(-static_cast<Real>(k) / 128), 32); };
    if (i == 128) return off(detail::exp_table.y[i], detail::exp_table.y[0] / 2);
    return off(detail::exp_table.y[i], std::fmin(lowered(exact, i, 128), 4294967295.0L));
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
/// Floored, a root of a floored root: within a unit of 2^-64, which long double only just resolves.
double root_of_half_entry(uint64_t i) {
    return off(detail::roots_of_half.y[i + 1], std::ldexp(std::exp2(-std::ldexp(1.0L, -static_cast<int>(i) - 1)), 64));
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
        worst = std::fmax(worst, off(window.y[k], wanted));
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
    add("table of 49 for rsqrt", "num/rsqrt.hpp", 49, table_max_error.milli / 1000.0, rsqrt_entry<6>);
    add("table of 97 for rsqrt", "num/rsqrt.hpp", 97, table_max_error.milli / 1000.0, rsqrt_entry<7>);
    add("table for the reciprocal", "num/reciprocal.hpp", 65, table_max_error.milli / 1000.0, reciprocal_entry);
    add("table for the logarithm", "num/shininess_shared.hpp", 65, detail::shared_table_max_error.milli / 1000.0,
        log_entry);
    add("table for the power of two", "num/shininess_shared.hpp", 129, detail::shared_table_max_error.milli / 1000.0,
        exp_entry);
    add("middles for the logarithm", "num/scaled_power.hpp", 32, table_max_error.milli / 1000.0, middle_log_entry);
    add("middles for the power of two", "num/scaled_power.hpp", 32, table_max_error.milli / 1000.0, middle_exp_entry);
    add("divisors of the sine and cosine", "num/angle.hpp", 5, table_max_error.milli / 1000.0, divisor_entry);
    add("roots of a half", "num/power.hpp", 48, detail::roots_of_half_max_error.milli / 1000.0, root_of_half_entry);
    add("windows of lowp", "num/shininess_window.hpp", 64, table_max_error.milli / 1000.0, window_entry<lowp>);
    add("windows of mediump", "num/shininess_window.hpp", 64, table_max_error.milli / 1000.0, window_entry<mediump>);
}

}  // namespace shade16::bounds
