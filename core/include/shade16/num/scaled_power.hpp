// x^p of a Scaled for any real p, of either sign: the falloff of lamps and the exponent of spots, which must keep their digits
// where they are small. The shininess kernels need only be exact against full scale.
#pragma once

#include "shade16/num/power.hpp"

namespace shade16 {

namespace detail {
inline constexpr int power_segments_log2 = 5;

/// For the middle of each of 32 segments of [1, 2): 1/c as Q32, and -log2 of that very number as Q32.
struct MiddleLogTable {
    uint32_t inverse[32]{}, log[32]{};
    consteval MiddleLogTable() {
        for (uint64_t i = 0; i < 32; ++i) {
            inverse[i] = static_cast<uint32_t>((uint64_t{64} << 32) / (65 + 2 * i));
            log[i] = static_cast<uint32_t>((negative_log2(uint64_t{inverse[i]} << 32) + 0x8000) >> 16);
        }
    }
};
/// 2^f for the middle of each of 32 segments of [0, 1), as Q31.
struct MiddleExpTable {
    uint32_t y[32]{};
    consteval MiddleExpTable() {
        for (uint64_t i = 0; i < 32; ++i) y[i] = exp2_negative((uint64_t{1} << 48) - ((2 * i + 1) << 42));
    }
};
SHADE16_TABLE MiddleLogTable middle_log_table{};
SHADE16_TABLE MiddleExpTable middle_exp_table{};

inline constexpr uint32_t log2_of_normalized_max_error = 3;  // of 2^-32
inline constexpr uint32_t scaled_exp2_of_fraction_max_error = 8;  // relative, of 2^-32

/// log2(x / 2^31) as Q32, for x with its top bit set. Error: log2_of_normalized_max_error.
/// Source  log2(x) = log2(c) + log2(1 + r), r = x/c - 1, |r| <= 1/65, and the series of the logarithm to r^4.
constexpr int64_t log2_of_normalized(uint32_t x) {
    constexpr int32_t third = 0x2AAAAAAB, half = 0x40000000, inverse_ln2_q30 = 0x5C551D95;
    const uint32_t i = (x >> (31 - power_segments_log2)) & 31;
    const int32_t r = static_cast<int32_t>(static_cast<int64_t>(multiply(x, middle_log_table.inverse[i]) - (uint64_t{1} << 63)) >> 26);  // Q37
    const int32_t b = half - (mulhi(r, third - (r >> 8)) >> 5);   // 1/2 - r/3 + r^2/4, Q31
    const int32_t natural = r - (mulhi(r, mulhi(r, b)) >> 4);     // ln(1 + r), Q37
    return int64_t{middle_log_table.log[i]} + ((mulhi(natural, inverse_ln2_q30) + 4) >> 3);
}

/// 2^(f / 2^32) as a Scaled. Error: scaled_exp2_of_fraction_max_error.
/// Source  2^f = 2^c 2^g, |g| <= 1/64, and the exponential series to g^3.
constexpr Scaled scaled_exp2_of_fraction(uint32_t f) {
    constexpr uint32_t ln2_q32 = 0xB17217F8;
    constexpr int32_t sixth = 0x15555555, half = 0x40000000;
    const int32_t g = static_cast<int32_t>((f << 5) - (uint32_t{1} << 31));  // Q37
    const int32_t y = mulhi(g, ln2_q32);
    const int32_t square = mulhi(y, mulhi(y, half + (mulhi(y, sixth) >> 5)));  // y^2/2 + y^3/6, Q41
    const uint32_t middle = middle_exp_table.y[f >> 27];
    return Scaled::normalized(static_cast<uint64_t>((int64_t{middle} << 5) + mulhi(y + (square >> 4), middle)), -36);
}
}  // namespace detail

/// Relative, in units of 2^-40: this, and so much more for each unit of |p|. 2^-24 for the largest that lamps have, 128.
inline constexpr uint32_t scaled_power_max_error = 2048, scaled_power_max_error_each = 388;

/// x^p, p = exponent / 2^fraction_bits.
/// Range   x > 0, fraction_bits up to 31; 0 gives 0 for a positive exponent and the largest Scaled for a negative one.
/// Error   relative 2^-29 + |p| 2^-31.4: scaled_power_max_error and scaled_power_max_error_each.
/// Cost    three long multiplies and nine high words.
/// Source  x^p = 2^(p log2 x), the logarithm and the power by a table of 32 middles and a short series each.
SHADE16_ONCE constexpr Scaled power(Scaled x, int32_t exponent, int fraction_bits) {
    if (x.is_zero()) return exponent > 0 ? Scaled{} : Scaled{UINT32_MAX, INT16_MAX};
    const int64_t fraction = multiply(exponent, static_cast<uint32_t>(clamp<int64_t>(detail::log2_of_normalized(x.mantissa), 0, UINT32_MAX)));
    const int64_t whole = multiply(int32_t{x.exponent} - 1, exponent);  // the logarithm's whole part, in units of 2^fraction_bits
    const int64_t below = whole & ((int64_t{1} << fraction_bits) - 1);
    const int64_t rest = (below << (32 - fraction_bits)) + shift_right_round(fraction, fraction_bits);  // Q32
    const Scaled mantissa = detail::scaled_exp2_of_fraction(static_cast<uint32_t>(rest));
    return {mantissa.mantissa, static_cast<int32_t>(clamp<int64_t>((whole >> fraction_bits) + (rest >> 32) + mantissa.exponent, INT16_MIN, INT16_MAX))};
}

}  // namespace shade16
