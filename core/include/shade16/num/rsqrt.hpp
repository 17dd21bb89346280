// 1/sqrt(x) on a mantissa: one linear table, and in highp one Newton step. Linear interpolation beats a larger nearest
// table plus Newton at every size below 2^-14.
#pragma once

#include "shade16/num/scaled.hpp"

namespace shade16 {

/// floor(sqrt(x)), for table builders.  Range  any.  Error  none.  Cost  32 steps.  Source  digit by digit.
constexpr uint32_t isqrt(uint64_t x) {
    uint64_t root = 0;
    for (uint64_t bit = uint64_t{1} << 62; bit != 0; bit >>= 2) {
        const uint64_t trial = root + bit;
        root >>= 1;
        if (x >= trial) {
            x -= trial;
            root += bit;
        }
    }
    return static_cast<uint32_t>(root);
}

namespace detail {
/// 2^16 * 0.5 / sqrt(i / 2^Bits) for i = 2^(Bits-2) .. 2^Bits, lowered by h^2 f''/16 (which is f * 3 / 64 i^2) and capped
/// at 65533: above that, 32768 times an entry plus the rounding constant leaves 32 bits.
template <int Bits>
struct RsqrtTable {
    static constexpr uint32_t first = uint32_t{1} << (Bits - 2);
    uint16_t y[3 * first + 1]{};
    consteval RsqrtTable() {
        for (uint64_t i = first; i <= 4 * first; ++i) {
            const uint64_t f = isqrt((uint64_t{1} << (54 + Bits)) / i);  // Q16 with 12 guard bits
            const uint64_t lowered = f - f * 3 / (64 * i * i);
            y[i - first] = static_cast<uint16_t>(min<uint64_t>((lowered + 2048) >> 12, 65533));
        }
    }
};
SHADE16_TABLE RsqrtTable<6> rsqrt_table_49{};
SHADE16_TABLE RsqrtTable<7> rsqrt_table_97{};
template <int Bits>
SHADE16_INLINE constexpr const RsqrtTable<Bits>& rsqrt_table() {
    if constexpr (Bits == 6) return rsqrt_table_49;
    else return rsqrt_table_97;
}
}  // namespace detail

/// Relative errors of the three forms, in units of 2^-32.
inline constexpr uint32_t rsqrt_49_max_error = 818'000;  // 1.90e-4
inline constexpr uint32_t rsqrt_97_max_error = 238'000;  // 5.5e-5
inline constexpr uint32_t rsqrt_newton_max_error = 240;  // 5.6e-8

/// 2^16 * 0.5 / sqrt(s / 2^32), by a table of 3 * 2^(Bits-2) + 1 entries: Bits 6 is 49 of them, 7 is 97.
/// Range   s in [2^30, 2^32).
/// Error   rsqrt_49_max_error or rsqrt_97_max_error.
/// Cost    one multiply, two table reads.
/// Source  linear interpolation between entries that are lowered by a sixteenth of the second difference.
template <int Bits>
SHADE16_INLINE constexpr uint32_t rsqrt_linear(uint32_t s) {
    const auto& table = detail::rsqrt_table<Bits>();
    const uint32_t index = (s >> (32 - Bits)) - table.first;
    const uint32_t fraction = (s << Bits) >> 16;
    const uint32_t a = table.y[index], b = table.y[index + 1];
    return a - (((a - b) * fraction + 0x8000) >> 16);
}

namespace detail {
/// One Newton step for 2^32 * 0.5 / sqrt(s / 2^32): r' = r + r (1 - 4 s r^2) / 2.
SHADE16_INLINE constexpr uint32_t rsqrt_step(uint32_t r, uint32_t s) {
    const int32_t residual = static_cast<int32_t>((uint32_t{1} << 30) - mulhi(mulhi(r, r), s));
    return r + 2 * static_cast<uint32_t>(mulhi(residual, r));
}
}  // namespace detail

/// 2^32 * 0.5 / sqrt(s / 2^32).
/// Range   s in [2^30, 2^32).
/// Error   rsqrt_newton_max_error, proved in tests/proof of whatever keeps rsqrt_49_max_error; never past the last word.
/// Cost    rsqrt_linear and three high words.
/// Source  Newton's method, one step on the table of 49 entries.
SHADE16_INLINE constexpr uint32_t rsqrt_newton(uint32_t s) {
    return detail::rsqrt_step(rsqrt_linear<6>(s) << 16, s);
}

inline constexpr uint32_t scaled_sqrt_max_error = 242;  // relative, of 2^-32

/// sqrt(x).
/// Range   any x; 0 gives 0.
/// Error   scaled_sqrt_max_error: rsqrt_newton_max_error and one rounding.
/// Cost    rsqrt_newton, a long multiply and Scaled::normalized.
/// Source  sqrt(x) = x / sqrt(x).
constexpr Scaled sqrt(Scaled x) {
    if (x.is_zero()) return {};
    const int odd = x.exponent & 1;
    const uint32_t s = x.mantissa >> odd;  // x = s * 2^(exponent + odd - 32), an even power
    return Scaled::normalized(multiply(s, rsqrt_newton(s)), (int32_t{x.exponent} + odd) / 2 - 63);
}

}  // namespace shade16
