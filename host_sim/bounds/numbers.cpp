#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "shade16/num/q16.hpp"
#include "shade16/num/q30.hpp"
#include "shade16/num/tier.hpp"
#include "shade16/num/ulps.hpp"
#include "shade16/num/unit14.hpp"

namespace shade16::bounds {
namespace {

double sums(Dice& dice) {
    const Q16 a = dice.q16(), b = dice.q16();
    Q16 c = a, d = a, e = a;
    c += b, d -= b, e *= b;
    Differences worst;
    worst((a + b).raw, nearest_word(Wide{a.raw} + b.raw))((a - b).raw, nearest_word(Wide{a.raw} - b.raw));
    worst(c.raw, (a + b).raw)(d.raw, (a - b).raw)(e.raw, (a * b).raw);
    return worst(a < b, a.raw < b.raw)(a > b, a.raw > b.raw)(a <= b, a.raw <= b.raw)(a >= b, a.raw >= b.raw);
}

}  // namespace

void add_numbers(Entries& to) {
    to.add({.name = "Q16, one operand",
            .header = "num/q16.hpp",
            .functions = "Q16::from_raw Q16::from_int Q16::operator-",
            .unit = "units"},
           [](uint64_t word) {
               const int32_t x = static_cast<int32_t>(word);
               return static_cast<double>(Differences()((-Q16::from_raw(x)).raw, nearest_word(-Wide{x}))(
                   Q16::from_int(x).raw, nearest_word(Wide{x} * 65536)));
           });
    to.add_random({.name = "Q16, two operands",
                   .header = "num/q16.hpp",
                   .functions = "Q16::operator+ Q16::operator- Q16::operator+= Q16::operator-= Q16::operator*= "
                                "Q16::operator< Q16::operator> Q16::operator<= Q16::operator>=",
                   .unit = "units"},
                  sums);
    to.add_random(
        {.name = "Q16 product",
         .header = "num/q16.hpp",
         .functions = "Q16::operator*",
         .unit = "ulp of Q16",
         .bound = in_ulps(q16_product_max_error)},
        [](Dice& dice) {
            const Q16 a = dice.q16(), b = dice.q16();
            const int64_t got = (a * b).raw, product = int64_t{a.raw} * b.raw;
            if (product >> 16 >= INT32_MAX || product >> 16 < INT32_MIN)
                return std::fabs(static_cast<double>(got - std::clamp<int64_t>(product >> 16, INT32_MIN, INT32_MAX)));
            return std::fabs(static_cast<double>(got * 65536 - product)) / 65536;
        });
    to.add({.name = "Q30, Unit14",
            .header = "num/q30.hpp num/unit14.hpp",
            .functions = "Q30::from_raw Q30::operator- Unit14::from_raw",
            .unit = "units"},
           [](uint64_t word) {
               const int32_t x = static_cast<int32_t>(word);
               Differences worst;
               worst(Q30::from_raw(int64_t{x} * 3).raw, nearest_word(Wide{x} * 3))((-Q30{x}).raw,
                                                                                   nearest_word(-Wide{x}));
               return static_cast<double>(worst(Unit14::from_raw(x).raw, std::clamp(x, -32768, 32767)));
           });
    static constexpr int64_t written[] = {(0.1_q16).raw, (-0.1_q16).raw, (1.5_q16).raw, (32767.5_q16).raw,
                                          (0.00001_q16).raw};
    static constexpr double meant[] = {0.1, -0.1, 1.5, 32767.5, 0.00001};
    to.add({.name = "Q16 literals",
            .header = "num/q16.hpp",
            .functions = "operator\"\"_q16",
            .unit = "ulp of Q16",
            .bound = in_ulps(literal_max_error),
            .inputs = {0, std::size(written) - 1}},
           [](uint64_t i) { return std::fabs(static_cast<double>(written[i]) - meant[i] * 65536); });
    to.add_random({.name = "amounts of error",
                   .header = "num/ulps.hpp num/tier.hpp",
                   .functions = "Ulps::operator<= operator\"\"_ulps Levels::operator<= operator\"\"_levels",
                   .unit = "units"},
                  [](Dice& dice) {
                      const uint32_t a = dice.word(), b = dice.word();
                      Differences worst;
                      worst(Ulps{a} <= Ulps{b}, a <= b)(Levels{a} <= Levels{b}, a <= b);
                      return static_cast<double>(worst((0.501_ulps).milli, 501)((2.5_levels).micro, 2'500'000));
                  });
}

}  // namespace shade16::bounds
