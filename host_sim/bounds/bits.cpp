#include "shade16/num/bits.hpp"

#include <bit>

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "shade16/num/literal.hpp"

namespace shade16::bounds {
namespace {

double shifts(Dice& dice) {
    const int32_t x = dice.number();
    const int64_t y = dice.long_number();
    const int n = dice.integer(0, 31), m = dice.integer(0, 63), any = dice.integer(-200, 200);
    Differences worst;
    worst(shift_left(x, n), static_cast<int32_t>(static_cast<uint32_t>(Wide{x} << n)));
    worst(shift_right_round(x, n), rounded_half_up(x, n));
    worst(shift_right_round(y, m), rounded_half_up(y, m));
    worst(shift_right_round(static_cast<uint64_t>(y), m), rounded_half_up(static_cast<uint64_t>(y), m));
    worst(saturate(y), std::clamp<int64_t>(y, INT32_MIN, INT32_MAX));
    const Wide scaled = any <= 0 ? rounded_half_up(y, std::min(-any, 100)) : Wide{y} * (Wide{1} << std::min(any, 62));
    worst(scale_by_power_of_two(y, any), std::clamp<Wide>(scaled, INT32_MIN, INT32_MAX));
    return worst;
}

double order(Dice& dice) {
    const int32_t a = dice.number(), b = dice.number(), c = dice.number();
    const uint64_t d = dice.long_word(), e = dice.long_word();
    Differences worst;
    worst(min(a, b), std::min(a, b))(max(a, b), std::max(a, b))(clamp(a, std::min(b, c), std::max(b, c)),
                                                                std::clamp(a, std::min(b, c), std::max(b, c)));
    return worst(min(d, e), std::min(d, e))(max(d, e), std::max(d, e))(opaque(a), a)(opaque(d), d);
}

}  // namespace

void add_bits(Entries& to) {
    to.add({.name = "leading_zeros", .header = "num/bits.hpp", .functions = "leading_zeros", .unit = "bits"},
           [](uint64_t x) {
               const uint32_t w = static_cast<uint32_t>(x);
               return static_cast<double>(Differences()(leading_zeros(w), std::countl_zero(w))(
                   leading_zeros(x << 32), std::countl_zero(x << 32))(leading_zeros(x), std::countl_zero(x)));
           });
    to.add({.name = "magnitude", .header = "num/bits.hpp", .functions = "magnitude", .unit = "units"},
           [](uint64_t word) {
               const int64_t x = static_cast<int32_t>(word), y = static_cast<int64_t>(word << 32);
               return static_cast<double>(Differences()(magnitude(static_cast<int32_t>(x)), x < 0 ? -x : x)(
                   magnitude(y), y < 0 ? -Wide{y} : Wide{y}));
           });
    to.add_random({.name = "shifts",
                   .header = "num/bits.hpp",
                   .functions = "shift_left shift_right_round saturate scale_by_power_of_two",
                   .unit = "units"},
                  shifts);
    to.add_random(
        {.name = "min, max, clamp", .header = "num/bits.hpp", .functions = "min max clamp opaque", .unit = "units"},
        order);

    static constexpr uint64_t parsed[] = {parse_decimal("0", 65536, UINT32_MAX),
                                          parse_decimal("1'000.25", 65536, UINT32_MAX),
                                          parse_decimal("0.1", 65536, UINT32_MAX),
                                          parse_decimal("0.00001", 65536, UINT32_MAX),
                                          parse_decimal("3.14159265", uint64_t{1} << 24, UINT64_MAX),
                                          parse_decimal("32767.99999", 65536, UINT32_MAX)};
    static constexpr double wanted[] = {
        0, 1000.25 * 65536, 0.1 * 65536, 0.00001 * 65536, 3.14159265 * 16777216, 32767.99999 * 65536};
    to.add({.name = "decimal literals",
            .header = "num/literal.hpp",
            .functions = "parse_decimal",
            .unit = "units",
            .bound = in_ulps(literal_max_error),
            .inputs = {0, std::size(parsed) - 1}},
           [](uint64_t i) { return std::fabs(static_cast<double>(parsed[i]) - wanted[i]); });
}

}  // namespace shade16::bounds
