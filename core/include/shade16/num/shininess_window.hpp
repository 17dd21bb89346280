// x^n over the lit interval only, one small table a material: the form of the 16-bit tiers. The interval shrinks as 1/n
// while the curvature grows as n^2, so the number of entries hardly depends on the exponent, only on the promise.
#pragma once

#include "shade16/num/power.hpp"
#include "shade16/num/q16.hpp"
#include "shade16/num/reciprocal.hpp"
#include "shade16/num/tier.hpp"

namespace shade16 {

namespace detail {
/// An error in levels as a Q32 fraction of full scale.
constexpr uint32_t as_q32(Levels e) { return static_cast<uint32_t>((uint64_t{e.micro} << 32) / 255'000'000); }

/// Segments that keep linear interpolation of e^-t within `error`: ln(1/e) / (4 sqrt(e)), with 15 % kept for rounding.
consteval uint32_t window_segments(Levels error) {
    const uint64_t e = as_q32({error.micro / 100 * 85});
    const uint64_t ln2_q16 = 45426, ln_q24 = (negative_log2(e << 32) >> 24) * ln2_q16 >> 16;
    const uint64_t divisor = isqrt(e << 32) >> 8 << 2;
    return static_cast<uint32_t>((ln_q24 + divisor - 1) / divisor);
}
}  // namespace detail

inline constexpr Q16 min_shininess = 1, max_shininess = 1000;

/// (1 - u)^n for one n, as a table over u in [0, u_end).
template <uint32_t Segments>
struct ShininessWindow {
    uint32_t u_end = 0;   // Q29; from here on the power is 0
    uint32_t scale = 0;   // cells to table position
    uint8_t cell_bits = 0;  // u is read in cells of 2^cell_bits, 2^15 to 2^16 of them in the window
    uint16_t y[Segments + 1]{};

    /// (1 - u)^n as a Q16 fraction, at most 65535.
    /// Range   u in Q29 (which is |N - H|^2 in Q28); u >= 1 gives 0.
    /// Error   Arithmetic<Tier>::shininess_max_error, for every n in [1, 1000]; never rises with u.
    /// Cost    two multiplies, two table reads; M0+ 32, M3 24 cycles (prototype figures).
    /// Source  linear interpolation over the interval where the power is above the promise's share.
    SHADE16_INLINE constexpr uint32_t power(uint32_t u) const {
        if (u >= u_end) return 0;
        const uint32_t position = ((u >> cell_bits) * scale + (scale >> 1)) >> 8;
        const uint32_t index = position >> 16, fraction = position & 0xFFFF;
        const uint32_t a = y[index], b = y[index + 1];
        return a - (((a - b) * fraction) >> 16);
    }

    /// The table for one exponent, clamped to [1, 1000]. The same bits at compile time and at run time.
    static constexpr ShininessWindow build(Q16 exponent, Levels error) {
        const uint32_t n = static_cast<uint32_t>(clamp(exponent.raw, min_shininess.raw, max_shininess.raw));
        ShininessWindow w;
        w.choose_interval(n, error);
        uint32_t exact[Segments + 1]{};
        const uint32_t step = quotient(w.u_end, Segments), rest = w.u_end - step * Segments;
        for (uint32_t i = 0; i <= Segments; ++i)
            exact[i] = power_of_complement((step * i + quotient(rest * i, Segments)) << 3, n);
        for (uint32_t i = 0; i <= Segments; ++i) w.y[i] = lowered(exact, i);
        return w;
    }

private:
    constexpr void choose_interval(uint32_t n, Levels error) {
        const Scaled log = Scaled::normalized(negative_log2(uint64_t{detail::as_q32(error)} << 32), -48);
        const Scaled log_over_n = log * reciprocal(Scaled::normalized(n, -16));
        const uint64_t t = log_over_n.to_fixed(48);
        const uint32_t window = (0u - exp2_negative(t)) >> 3;  // 1 - error^(1/n), in Q29
        cell_bits = static_cast<uint8_t>(max(0, 16 - leading_zeros(window)));
        const uint32_t cells = (window >> cell_bits) + 1;  // whole cells that hold the window
        u_end = cells << cell_bits;
        scale = quotient(Segments << 24, cells);
    }

    /// An entry lowered by a sixteenth of the second difference, so that chords err alike on both sides of the curve.
    static constexpr uint16_t lowered(const uint32_t (&exact)[Segments + 1], uint32_t i) {
        const auto curvature = [&](uint32_t k) {
            return static_cast<int64_t>(uint64_t{exact[k - 1]} + exact[k + 1]) - 2 * static_cast<int64_t>(exact[k]);
        };
        int64_t c = 0;
        if (i == 0) c = 2 * curvature(1) - curvature(2);
        else if (i == Segments) c = curvature(Segments - 1);
        else c = curvature(i);
        const int64_t lowering = clamp<int64_t>(c / 16, 0, exact[i] / 2);
        return static_cast<uint16_t>(min<int64_t>((static_cast<int64_t>(exact[i]) - lowering + 0x8000) >> 16, 65535));
    }
};

}  // namespace shade16
