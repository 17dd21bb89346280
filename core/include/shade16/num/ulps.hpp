// How far the result of a function may be from the exact value. The nearest number is at most half a unit away.
#pragma once

#include "shade16/num/literal.hpp"

namespace shade16 {

/// An amount of error, in thousandths of a unit in the last place of the result: 2^-16 for Q16.
struct Ulps {
    uint32_t milli = 0;
    friend constexpr bool operator==(Ulps, Ulps) = default;
    friend constexpr bool operator<=(Ulps a, Ulps b) { return a.milli <= b.milli; }
};
consteval Ulps operator""_ulps(const char* digits) {
    return {static_cast<uint32_t>(parse_decimal(digits, 1000, 1'000'000))};
}

/// A literal with up to nine decimals, in units of its type; an angle in degrees is scaled twice.
inline constexpr Ulps literal_max_error = 0.5_ulps, degrees_literal_max_error = 0.502_ulps;

/// An entry of any table, in units of its last place: rounded from a number with guard bits.
inline constexpr Ulps table_max_error = 0.501_ulps;

}  // namespace shade16
