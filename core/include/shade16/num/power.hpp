// x^n in integers, slowly and to 40 bits: what the shininess tables are built from, at compile time or at run time.
#pragma once

#include "shade16/num/rsqrt.hpp"

namespace shade16 {

namespace detail {
/// 2^(-2^-k) for k = 1 .. 48, as Q64: each the square root of the one before.
struct RootsOfHalf {
    uint64_t y[49]{};
    consteval RootsOfHalf() {
        uint64_t square = uint64_t{1} << 63;  // 2^-1
        for (int k = 1; k <= 48; ++k) {
            for (uint64_t bit = uint64_t{1} << 63; bit != 0; bit >>= 1)  // sqrt, digit by digit
                if (mulhi(y[k] | bit, y[k] | bit) <= square) y[k] |= bit;
            square = y[k];
        }
    }
};
inline constexpr RootsOfHalf roots_of_half{};
}  // namespace detail

inline constexpr int negative_log2_max_error_log2 = -47, exp2_negative_max_error_log2 = -32, power_of_complement_max_error_log2 = -32;

/// -log2(x / 2^64) as Q48.
/// Range   x > 0.  Error  negative_log2_max_error_log2.  Cost  48 64-bit multiplies.  Source  bit by bit: squaring doubles a logarithm.
constexpr uint64_t negative_log2(uint64_t x) {
    const int zeros = leading_zeros(x);
    x <<= zeros;  // the mantissa in [1/2, 1)
    uint64_t log = 0;
    for (int k = 1; k <= 48; ++k) {  // log2 of 2m in [1, 2), a bit at a time
        x = mulhi(x, x);
        log <<= 1;
        if (x >> 63) log |= 1;  // (2m)^2 >= 2: m^2 >= 1/2
        else x <<= 1;
    }
    return (static_cast<uint64_t>(zeros + 1) << 48) - log;
}

namespace detail {
/// 2^-f as Q64, for the fraction f of t in Q48.
constexpr uint64_t exp2_of_fraction(uint64_t t) {
    uint64_t y = UINT64_MAX;
    for (int k = 1; k <= 48; ++k)
        if (t >> (48 - k) & 1) y = mulhi(y, roots_of_half.y[k]);
    return y;
}
}  // namespace detail

/// 2^-t as Q32, for t in Q48; at most 2^32 - 1.
/// Range   any t.  Error  exp2_negative_max_error_log2.
/// Cost    a 64-bit multiply for each bit of the fraction that is set.  Source  a product of roots of a half.
constexpr uint32_t exp2_negative(uint64_t t) {
    const uint64_t whole = t >> 48;
    if (whole > 32) return 0;
    const uint64_t y = detail::exp2_of_fraction(t) >> whole;
    return static_cast<uint32_t>(min<uint64_t>((y >> 32) + (y >> 31 & 1), UINT32_MAX));
}

/// t * n for a Q48 logarithm and a Q16 exponent, saturated.
constexpr uint64_t times_q16(uint64_t t, uint32_t n) {
    const uint64_t high = multiply(static_cast<uint32_t>(t >> 32), n), low = multiply(static_cast<uint32_t>(t), n);
    const uint64_t product = (high << 16) + (low >> 16);
    return high >> 48 != 0 || product < high << 16 ? UINT64_MAX : product;
}

/// (1 - u)^n as Q32, for u in Q32 and n in Q16; at most 2^32 - 1.
/// Range   n up to 1000.  Error  power_of_complement_max_error_log2.
/// Cost    those of negative_log2 and exp2_negative.  Source  x^n = 2^(n log2 x).
constexpr uint32_t power_of_complement(uint32_t u, uint32_t n) {
    if (u == 0) return UINT32_MAX;
    return exp2_negative(times_q16(negative_log2(uint64_t{0u - u} << 32), n));
}

}  // namespace shade16
