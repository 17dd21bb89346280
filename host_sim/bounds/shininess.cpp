#include <vector>

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "host_sim/bounds/kernel.hpp"

namespace shade16::bounds {
namespace {

double levels(double error) { return 255 * std::fabs(error); }

/// (1 - u)^n for u = first, first + h, ... by the binomial series from the first: a power costs more than the kernel
/// does.
class PowersInARow {
public:
    static constexpr uint64_t length = 64;

    PowersInARow(double n, double h) : n_(n), h_(h) {}
    void start(double u) {
        const double rest = 1 - u;
        first_ = std::pow(rest, n_), step_ = h_ / rest;
        is_short_ = rest > 0 && n_ * step_ * length < 0x1p-8;  // to the fourth power, the series is then exact to 1e-14
        u_ = u;
    }
    double at(uint64_t k) const {
        if (!is_short_) return std::pow(std::fmax(1 - u_ - static_cast<double>(k) * h_, 0.0), n_);
        const double z = static_cast<double>(k) * step_;
        return first_ * (1 - n_ * z * (1 - (n_ - 1) / 2 * z * (1 - (n_ - 2) / 3 * z * (1 - (n_ - 3) / 4 * z))));
    }

private:
    double n_, h_, first_ = 1, step_ = 0, u_ = 0;
    bool is_short_ = false;
};

constexpr uint64_t exponent_count = 32;
/// From 1 to 1000, each in the same ratio to the one before.
Q16 exponent_number(uint64_t i) {
    return Q16::from_raw(
        static_cast<int32_t>(std::lround(65536 * std::pow(1000.0, static_cast<double>(i) / (exponent_count - 1)))));
}

/// Inputs of one exponent: every stride-th u from first to last.
template <class Tier>
void measure_u(Peak& peak, uint64_t exponent, Span us) {
    constexpr int bits = Kernel<Tier>::u_bits;
    const Q16 n = exponent_number(exponent);
    const auto kernel = shininess<Tier>(n);
    PowersInARow exact(n.raw / 65536.0, std::ldexp(static_cast<double>(us.stride), -bits));
    for (uint64_t u = us.first, k = 0; u <= us.last; u += us.stride, k = (k + 1) % PowersInARow::length) {
        if (k == 0) exact.start(std::ldexp(static_cast<double>(u), -bits));
        peak.add(levels(std::ldexp(static_cast<double>(kernel.power(static_cast<uint32_t>(u))),
                                   -Kernel<Tier>::fraction_bits) -
                        exact.at(k)),
                 exponent << bits | u);
    }
}

/// All u for 32 exponents.
template <class Tier>
Peak measure_every_u(const Span& span) {
    constexpr int bits = Kernel<Tier>::u_bits;
    Peak peak;
    for (uint64_t first = span.first; first <= span.last;) {
        const uint64_t exponent = first >> bits, end_of_exponent = (exponent << bits) | ((uint64_t{1} << bits) - 1);
        const uint64_t last = std::min(span.last, end_of_exponent), base = exponent << bits;
        measure_u<Tier>(peak, exponent, {first - base, last - base, span.stride});
        first += (last - first) / span.stride * span.stride + span.stride;
    }
    return peak;
}

constexpr uint64_t x_count = 65537, n_steps = 999 * 16 + 1;  // x in Q16 from 0 to 1, n in sixteenths from 1 to 1000

std::vector<double> logarithms() {
    std::vector<double> logs(x_count, -1e9);
    for (uint64_t x = 1; x < x_count; ++x) logs[x] = std::log2(static_cast<double>(x) / 65536);
    return logs;
}

/// All x in Q16 for n in sixteenths.
template <class Tier>
Peak measure_every_x(const Span& span) {
    static const std::vector<double> logs = logarithms();
    Peak peak;
    uint64_t step = UINT64_MAX;
    auto kernel = shininess<Tier>(1);
    for (uint64_t i = span.first; i <= span.last; i += span.stride) {
        const uint64_t x = i % x_count;
        if (i / x_count != step)
            step = i / x_count, kernel = shininess<Tier>(Q16::from_raw(static_cast<int32_t>((16 + step) * 4096)));
        const uint32_t u =
            static_cast<uint32_t>(std::min<uint64_t>((65536 - x) << (Kernel<Tier>::u_bits - 16), UINT32_MAX));
        const double exact = std::exp2(static_cast<double>(16 + step) / 16 * logs[x]);
        peak.add(levels(std::ldexp(static_cast<double>(kernel.power(u)), -Kernel<Tier>::fraction_bits) - exact), i);
    }
    return peak;
}

/// How much the kernel rises from u to a larger one: never.
template <class Tier>
double rise(Dice& dice) {
    const auto kernel =
        shininess<Tier>(Q16::from_raw(static_cast<int32_t>(65536 * std::pow(1000, dice.uniform(0, 1)))));
    double worst = 0;
    for (int i = 0; i < 64; ++i) {
        const uint32_t u = dice.word() >> (32 - Kernel<Tier>::u_bits),
                       beyond = u + 1 + dice.word() / 4 % (dice.below(2) != 0 ? 8 : 1 << 20);
        if (beyond > u)
            worst = larger(worst, static_cast<double>(kernel.power(beyond)) - static_cast<double>(kernel.power(u)));
    }
    return worst;
}

template <class Tier>
void add_tier(Entries& to) {
    const std::string functions = Kernel<Tier>::shared ? "ShininessShared::power ShininessShared::build shininess"
                                                       : "ShininessWindow::power ShininessWindow::build shininess";
    const std::string header = Kernel<Tier>::shared ? "num/shininess_shared.hpp num/shininess.hpp"
                                                    : "num/shininess_window.hpp num/shininess.hpp";
    const auto add = [&](const char* name, uint64_t inputs, Peak (*measure)(const Span&)) {
        to.add({.name = name,
                .header = header,
                .functions = functions,
                .unit = "levels",
                .tier = Tier::name,
                .bound = Kernel<Tier>::bound,
                .inputs = {0, inputs - 1},
                .measure = measure});
    };
    add("shininess, every u", exponent_count << Kernel<Tier>::u_bits, measure_every_u<Tier>);
    add("shininess, every x", x_count * n_steps, measure_every_x<Tier>);
    Entry falls{
        .name = "shininess never rises", .header = header, .functions = functions, .unit = "units", .tier = Tier::name};
    to.add_random(falls, rise<Tier>, 20'000);
}

}  // namespace

void add_shininess(Entries& to) {
    add_tier<lowp>(to);
    add_tier<mediump>(to);
    add_tier<highp>(to);
}

}  // namespace shade16::bounds
