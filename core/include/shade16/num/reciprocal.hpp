// 1/x, and exact quotients from it. This is the core's only division: a table and one Newton step, 130 bytes.
#pragma once

#include "shade16/num/scaled.hpp"

#if !defined(SHADE16_HAS_DIVIDER)
#if defined(__ARM_FEATURE_IDIV) || defined(__x86_64__) || defined(__aarch64__) || defined(__riscv_div) || defined(__wasm__)
#define SHADE16_HAS_DIVIDER 1
#else
#define SHADE16_HAS_DIVIDER 0
#endif
#endif

namespace shade16 {

namespace detail {
/// 2^16 / (1 + i/64), lowered by h^2 f''/16 so that linear interpolation errs alike on both sides, capped to 16 bits.
struct ReciprocalTable {
    uint16_t y[65]{};
    consteval ReciprocalTable() {
        for (uint64_t i = 0; i <= 64; ++i) {
            const uint64_t a = 64 + i, exact = (uint64_t{1} << 46) / a;           // 2^40 / a as Q16, 24 guard bits
            const uint64_t lowering = exact / (8 * a * a);                      // h^2/16 * 2/a^3 of f = 1/a, h = 1
            y[i] = static_cast<uint16_t>(min<uint64_t>((exact - lowering + (uint32_t{1} << 23)) >> 24, 65535));
        }
    }
};
SHADE16_TABLE ReciprocalTable reciprocal_table{};
}  // namespace detail

/// Relative errors, in units of 2^-32: of the table's line, and of the whole.
inline constexpr uint32_t reciprocal_linear_max_error = 142'337;  // 3.3e-5
inline constexpr uint32_t reciprocal_max_error = 9;  // 2.1e-9

namespace detail {
/// 2^63 / x as far as the table knows. Error: reciprocal_linear_max_error.
SHADE16_INLINE constexpr uint32_t reciprocal_linear(uint32_t x) {
    const uint32_t index = (x >> 25) & 63, fraction = (x >> 9) & 0xFFFF;
    const uint32_t a = reciprocal_table.y[index], b = reciprocal_table.y[index + 1];
    return (a << 16) - (a - b) * fraction;
}
}  // namespace detail

/// 2^63 / x.
/// Range   a normalised x, in [2^31, 2^32).
/// Error   reciprocal_max_error, proved in tests/proof; never past the last word.
/// Cost    two table reads and three multiplies: M3 32 cycles, M0+ 89 (prototype figures).
/// Source  Newton: r' = r (2 - x r).
SHADE16_INLINE constexpr uint32_t reciprocal_of_normalized(uint32_t x) {
    const uint32_t r = detail::reciprocal_linear(x);
    const int32_t residual = static_cast<int32_t>((uint32_t{1} << 31) - mulhi(r, x));
    const int32_t step = mulhi(residual, r);
    return r + 2 * static_cast<uint32_t>(step);
}

/// 1/x.
/// Range   x > 0; 0 gives the largest Scaled (mantissa and exponent at their ends).
/// Error   reciprocal_max_error.  Cost  reciprocal_of_normalized.  Source  1 / (m 2^e) = (1 / m) 2^-e.
SHADE16_ONCE constexpr Scaled reciprocal(Scaled x) {
    if (x.is_zero()) return {UINT32_MAX, INT16_MAX};
    return {reciprocal_of_normalized(x.mantissa), 1 - int32_t{x.exponent}};
}

namespace detail {
/// floor(n / d), d > 0, without a divider: an estimate from the reciprocal, then the remainder decides.
constexpr uint32_t quotient_by_reciprocal(uint32_t n, uint32_t d) {
    const int shift = leading_zeros(d);
    const uint32_t r = reciprocal_of_normalized(d << shift);
    uint32_t q = shift == 31 ? n : mulhi(n, r) >> (31 - shift);
    while (multiply(q, d) > n) --q;
    while (n - q * d >= d) ++q;
    return q;
}
}  // namespace detail

/// floor(n / d).
/// Range   d > 0; d = 0 gives UINT32_MAX.
/// Error   none, with or without a divider: the bits are the same.
SHADE16_INLINE constexpr uint32_t quotient(uint32_t n, uint32_t d) {
    if (d == 0) return UINT32_MAX;
#if SHADE16_HAS_DIVIDER
    return n / d;
#else
    return detail::quotient_by_reciprocal(n, d);
#endif
}

/// floor(n / d) for a signed n.
SHADE16_INLINE constexpr int32_t floor_quotient(int32_t n, uint32_t d) {
    return n >= 0 ? static_cast<int32_t>(quotient(static_cast<uint32_t>(n), d))
                  : -1 - static_cast<int32_t>(quotient(static_cast<uint32_t>(-1 - n), d));
}

}  // namespace shade16
