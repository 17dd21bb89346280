#include "shade16/num/scaled.hpp"

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/relative.hpp"

namespace shade16::bounds {
namespace {

Scaled any_scaled(Dice& dice, int octaves) { return {dice.mantissa(), dice.integer(-octaves, octaves)}; }

}  // namespace

void add_scaled(Entries& to) {
    to.add_random({.name = "Scaled::normalized",
                   .header = "num/scaled.hpp",
                   .functions = "Scaled::normalized",
                   .unit = "of it",
                   .bound = std::ldexp(1.0, scaled_product_max_error_log2)},
                  [](Dice& dice) {
                      const uint64_t value = dice.long_word() | 1;
                      const int exponent = dice.integer(-100, 100);
                      const Scaled s = Scaled::normalized(value, exponent);
                      return s.mantissa >> 31 == 1
                                 ? relative_error(wide(s), std::ldexp(static_cast<long double>(value), exponent))
                                 : 1;
                  });
    to.add_random({.name = "Scaled product",
                   .header = "num/scaled.hpp",
                   .functions = "Scaled::operator*",
                   .unit = "of it",
                   .bound = std::ldexp(1.0, scaled_product_max_error_log2)},
                  [](Dice& dice) {
                      const Scaled a = any_scaled(dice, 200), b = any_scaled(dice, 200);
                      return relative_error(wide(a * b), wide(a) * wide(b));
                  });
    to.add_random({.name = "Scaled sum",
                   .header = "num/scaled.hpp",
                   .functions = "Scaled::operator+",
                   .unit = "of it",
                   .bound = std::ldexp(1.0, scaled_sum_max_error_log2)},
                  [](Dice& dice) {
                      const Scaled a = any_scaled(dice, 40), b = any_scaled(dice, 40);
                      return relative_error(wide(a + b), wide(a) + wide(b));
                  });
    to.add_random({.name = "Scaled::to_fixed",
                   .header = "num/scaled.hpp",
                   .functions = "Scaled::to_fixed Scaled::is_zero",
                   .unit = "units"},
                  [](Dice& dice) {
                      const Scaled a = any_scaled(dice, 60);
                      if (a.is_zero() || !Scaled{}.is_zero()) return 1e9;
                      const int fraction_bits = dice.integer(-20, 64);
                      const long double exact = std::floor(std::ldexp(wide(a), fraction_bits));
                      return static_cast<double>(std::fabs(static_cast<long double>(a.to_fixed(fraction_bits)) -
                                                           std::fmin(exact, 18446744073709551615.0L)));
                  });
    static constexpr Scaled written[] = {0_scaled, 1_scaled, 0.1_scaled, 10000.5_scaled, Scaled(12345)};
    static constexpr double meant[] = {0, 1, 0.1, 10000.5, 12345};
    to.add({.name = "Scaled literals",
            .header = "num/scaled.hpp",
            .functions = "operator\"\"_scaled",
            .unit = "2^-24",
            .bound = in_ulps(literal_max_error),
            .inputs = {0, std::size(written) - 1}},
           [](uint64_t i) { return std::fabs(static_cast<double>(wide(written[i])) - meant[i]) * 16777216; });
}

}  // namespace shade16::bounds
