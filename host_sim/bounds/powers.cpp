#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "host_sim/bounds/relative.hpp"
#include "shade16/num/scaled_power.hpp"

namespace shade16::bounds {
namespace {

/// In shares of what an exponent is allowed.
double power_error(Scaled x, int32_t exponent, int fraction_bits) {
    const long double p = std::ldexp(static_cast<long double>(exponent), -fraction_bits);
    const double allowed =
        std::ldexp(scaled_power_max_error + scaled_power_max_error_each * std::fabs(static_cast<double>(p)), -40);
    return relative_error(wide(power(x, exponent, fraction_bits)), std::pow(wide(x), p)) / allowed;
}

/// What lamps ask for: d^-p of a distance squared, and a cosine to the 128th.
double falloff_error(Dice& dice) {
    const Scaled x{dice.mantissa(), dice.integer(-30, 30)};
    const int32_t exponent = -dice.integer(0, 2 * 65536);
    return power_error(x, exponent, 17);
}
double cosine_error(Dice& dice) {
    const Scaled x{dice.mantissa(), 0};
    const int32_t exponent = dice.integer(0, 128 * 65536);
    return power_error(x, exponent, 16);
}

double complement_error(Dice& dice) {
    const uint32_t u = dice.word(), n = dice.below(1000 * 65536 + 1);
    const long double exact =
        std::pow(1 - std::ldexp(static_cast<long double>(u), -32), std::ldexp(static_cast<long double>(n), -16));
    return static_cast<double>(std::fabs(std::ldexp(static_cast<long double>(power_of_complement(u, n)), -32) - exact));
}

}  // namespace

void add_powers(Entries& to) {
    const auto entry = [](const char* name, const char* functions, const char* unit, double bound) {
        return Entry{.name = name, .header = "num/power.hpp", .functions = functions, .unit = unit, .bound = bound};
    };
    to.add_random(
        entry("negative_log2", "negative_log2", "absolute", std::ldexp(1.0, negative_log2_max_error_log2)),
        [](Dice& dice) {
            const uint64_t x = std::max<uint64_t>(dice.long_word(), 1);
            const long double exact = 64 - std::log2(static_cast<long double>(x));
            return static_cast<double>(std::fabs(std::ldexp(static_cast<long double>(negative_log2(x)), -48) - exact));
        });
    to.add_random(
        entry("exp2_negative", "exp2_negative", "absolute", std::ldexp(1.0, exp2_negative_max_error_log2)),
        [](Dice& dice) {
            const uint64_t t = dice.below(2) != 0 ? dice.long_word() : dice.bits() >> 11;  // half of them below 32
            const long double exact = std::exp2(-std::ldexp(static_cast<long double>(t), -48));
            return static_cast<double>(std::fabs(std::ldexp(static_cast<long double>(exp2_negative(t)), -32) - exact));
        });
    to.add_random(entry("times_q16", "times_q16", "units", 0), [](Dice& dice) {
        const uint64_t t = dice.long_word();
        const uint32_t n = dice.word();
        const WideUnsigned wanted = std::min<WideUnsigned>(WideUnsigned{t} * n >> 16, UINT64_MAX);
        return static_cast<double>(wanted > times_q16(t, n) ? wanted - times_q16(t, n) : times_q16(t, n) - wanted);
    });
    to.add_random(entry("power_of_complement", "power_of_complement", "absolute",
                        std::ldexp(1.0, power_of_complement_max_error_log2)),
                  complement_error);
    to.add_random({.name = "power, falloff",
                   .header = "num/scaled_power.hpp",
                   .functions = "power",
                   .unit = "of 2^-29 + |p| 2^-31.4",
                   .bound = 1},
                  falloff_error);
    to.add_random({.name = "power, cosine",
                   .header = "num/scaled_power.hpp",
                   .functions = "power",
                   .unit = "of 2^-29 + |p| 2^-31.4",
                   .bound = 1},
                  cosine_error);
    to.add({.name = "logarithm for power",
            .header = "num/scaled_power.hpp",
            .functions = "",
            .unit = "2^-32",
            .bound = detail::log2_of_normalized_max_error,
            .inputs = {uint64_t{1} << 31, UINT32_MAX}},
           [](uint64_t x) {
               const double exact = std::log2(std::ldexp(static_cast<double>(x), -31)) * 0x1p32;
               return std::fabs(static_cast<double>(detail::log2_of_normalized(static_cast<uint32_t>(x))) - exact);
           });
    to.add({.name = "power of two for power",
            .header = "num/scaled_power.hpp",
            .functions = "",
            .unit = "2^-32 of it",
            .bound = detail::scaled_exp2_of_fraction_max_error},
           [](uint64_t f) {
               const long double exact = std::exp2(std::ldexp(static_cast<long double>(f), -32));
               return relative_error(wide(detail::scaled_exp2_of_fraction(static_cast<uint32_t>(f))), exact) * 0x1p32;
           });
}

}  // namespace shade16::bounds
