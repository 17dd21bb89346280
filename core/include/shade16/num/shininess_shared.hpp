// x^n for any real n from one pair of tables shared by all materials: the form of highp. Since max over n of
// n e^(-nu) = 1/(e u), the logarithm of 1 - u needs only relative accuracy in u.
#pragma once

#include "shade16/num/power.hpp"
#include "shade16/num/q16.hpp"
#include "shade16/num/shininess_window.hpp"

namespace shade16 {

namespace detail {
/// The entries lowered by a sixteenth of the second difference, as in ShininessWindow.
template <size_t N>
constexpr void lower_by_curvature(const int64_t (&exact)[N], uint32_t (&table)[N]) {
    for (size_t i = 0; i < N; ++i) {
        const size_t k = clamp<size_t>(i, 1, N - 2);
        const int64_t curvature = exact[k - 1] - 2 * exact[k] + exact[k + 1];
        table[i] = static_cast<uint32_t>(min<int64_t>(exact[i] - curvature / 16, UINT32_MAX));
    }
}

/// -log2(1 - u) / u on [0, 1/2] as Q31, 260 bytes.
struct LogTable {
    static constexpr int log2_segments = 6;
    uint32_t y[65]{};
    consteval LogTable() {
        int64_t exact[65]{0xB8AA3B29};  // 1 / ln 2
        for (uint64_t i = 1; i <= 64; ++i) {
            const uint64_t log = negative_log2((128 - i) << 57);  // at most 1.0 in Q48
            exact[i] = static_cast<int64_t>(log * 128 / i >> 17);
        }
        lower_by_curvature(exact, y);
    }
};
/// 2^-f on [0, 1] as Q32, 516 bytes.
struct ExpTable {
    static constexpr int log2_segments = 7;
    uint32_t y[129]{};
    consteval ExpTable() {
        int64_t exact[129]{int64_t{1} << 32};
        for (uint64_t i = 1; i <= 128; ++i) exact[i] = exp2_negative(i << 41);
        lower_by_curvature(exact, y);
        y[128] = y[0] >> 1;  // where one octave meets the next: 42 units less, and the power would rise there
    }
};
/// Of an entry, in its units, whose power and whose second difference are whole numbers before they are summed.
inline constexpr Ulps shared_table_max_error = 0.5_ulps;
SHADE16_TABLE LogTable log_table{};
SHADE16_TABLE ExpTable exp_table{};

/// Linear interpolation at position / 2^32 of a table.
template <class Table>
SHADE16_INLINE constexpr uint32_t interpolate(const Table& table, uint32_t position) {
    const uint32_t index = position >> (32 - Table::log2_segments);
    const int32_t rise = static_cast<int32_t>(table.y[index + 1] - table.y[index]);
    return table.y[index] + static_cast<uint32_t>(mulhi(rise, position << Table::log2_segments));
}
}  // namespace detail

/// (1 - u)^n for one n.
struct ShininessShared {
    uint32_t exponent = 65536;  // Q16, in [1, 1000]

    /// (1 - u)^n as a Q32 fraction, at most 2^32 - 1.
    /// Range   u in Q32; UINT32_MAX (the dot is 0 or negative) gives 0.
    /// Error   Arithmetic<highp>::shininess_max_error for every n in [1, 1000]; never rises with u.
    /// Cost    M0+ 140, M3 59 cycles (prototype figures); may change at run time at no cost.
    /// Source  x^n = 2^(n log2 x), both functions by linear interpolation.
    constexpr uint32_t power(uint32_t u) const {
        if (u == 0) return UINT32_MAX;
        if (u == UINT32_MAX) return 0;
        uint32_t mantissa = 0u - u;
        const int zeros = leading_zeros(mantissa);
        mantissa <<= zeros;
        const uint32_t v = 0u - mantissa;  // 1 - mantissa, in (0, 1/2]
        const uint32_t g = detail::interpolate(detail::log_table, v == uint32_t{1} << 31 ? UINT32_MAX : v << 1);
        const uint32_t log = static_cast<uint32_t>(multiply(v, g) >> 31);
        const uint64_t t = multiply(exponent, log) + (multiply(exponent, static_cast<uint32_t>(zeros)) << 32);  // Q48
        const uint32_t whole = static_cast<uint32_t>(t >> 48);
        if (whole > 31) return 0;
        return detail::interpolate(detail::exp_table, static_cast<uint32_t>(t >> 16)) >> whole;
    }

    static constexpr ShininessShared build(Q16 exponent, Levels) {
        return {static_cast<uint32_t>(clamp(exponent.raw, min_shininess.raw, max_shininess.raw))};
    }
};

}  // namespace shade16
