#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "host_sim/bounds/relative.hpp"
#include "shade16/num/reciprocal.hpp"

namespace shade16::bounds {

void add_reciprocals(Entries& to) {
    to.add({.name = "reciprocal_of_normalized",
            .header = "num/reciprocal.hpp",
            .functions = "reciprocal_of_normalized",
            .unit = "2^-32 of it",
            .bound = reciprocal_max_error,
            .inputs = {uint64_t{1} << 31, UINT32_MAX}},
           [](uint64_t x) {
               return std::fabs(reciprocal_of_normalized(static_cast<uint32_t>(x)) *
                                    std::ldexp(static_cast<double>(x), -63) -
                                1) *
                      0x1p32;
           });
    to.add_random({.name = "reciprocal",
                   .header = "num/reciprocal.hpp",
                   .functions = "reciprocal",
                   .unit = "2^-32 of it",
                   .bound = reciprocal_max_error},
                  [](Dice& dice) {
                      const Scaled x{dice.mantissa(), dice.integer(-200, 200)};
                      return relative_error(wide(reciprocal(x)) * wide(x), 1) * 0x1p32;
                  });
    to.add_random(
        {.name = "quotient, floor_quotient",
         .header = "num/reciprocal.hpp",
         .functions = "quotient floor_quotient",
         .unit = "units"},
        [](Dice& dice) {
            const uint32_t n = dice.word(), d = dice.word();
            const int32_t s = dice.number();
            if (d == 0) return static_cast<double>(Differences()(quotient(n, d), UINT32_MAX));
            const uint32_t multiple = n - n % d;  // where an estimate is easily one off
            Differences worst;
            worst(quotient(n, d), n / d)(detail::quotient_by_reciprocal(n, d), n / d)(
                detail::quotient_by_reciprocal(multiple, d), n / d);
            if (multiple != 0) worst(detail::quotient_by_reciprocal(multiple - 1, d), n / d - 1);
            return static_cast<double>(worst(floor_quotient(s, d), s >= 0 ? Wide{s} / d : -((Wide{d} - 1 - s) / d)));
        });
}

}  // namespace shade16::bounds
