// Q30: signed 32 bits, 30 of them fraction. Rotations in every tier, unit vectors in highp.
#pragma once

#include "shade16/num/bits.hpp"

namespace shade16 {

/// A number in [-2, 2) in steps of 2^-30.
struct Q30 {
    int32_t raw = 0;

    static constexpr int fraction_bits = 30;
    static constexpr int32_t one = int32_t{1} << fraction_bits;
    static constexpr Q30 from_raw(int64_t raw) { return {saturate(raw)}; }
    friend constexpr bool operator==(Q30, Q30) = default;
    friend constexpr Q30 operator-(Q30 a) { return from_raw(-int64_t{a.raw}); }
};

}  // namespace shade16
