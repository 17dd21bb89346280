// How far a function that returns Q16 may be from the exact value. The nearest Q16 is at most half a unit away.
#pragma once

#include "shade16/num/literal.hpp"

namespace shade16 {

/// An amount of error, in thousandths of a unit in the last place of Q16, which is 2^-16.
struct Ulps {
    uint32_t milli = 0;
    friend constexpr bool operator==(Ulps, Ulps) = default;
    friend constexpr bool operator<=(Ulps a, Ulps b) { return a.milli <= b.milli; }
};
consteval Ulps operator""_ulps(const char* digits) {
    return {static_cast<uint32_t>(parse_decimal(digits, 1000, 1'000'000))};
}

}  // namespace shade16
