// Angle: binary turns, and the sine and cosine of one.
#pragma once

#include "shade16/num/literal.hpp"
#include "shade16/num/mulhi.hpp"
#include "shade16/num/q30.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16 {

/// An angle in units of 2^-32 turn. It wraps as angles do: adding past a full turn is no overflow.
struct Angle {
    uint32_t turns = 0;

    friend constexpr bool operator==(Angle, Angle) = default;
    friend constexpr Angle operator+(Angle a, Angle b) { return {a.turns + b.turns}; }
    friend constexpr Angle operator-(Angle a, Angle b) { return {a.turns - b.turns}; }
    friend constexpr Angle operator-(Angle a) { return {0u - a.turns}; }
    friend constexpr Angle operator*(Angle a, uint32_t n) { return {a.turns * n}; }
    constexpr Angle& operator+=(Angle b) { return *this = *this + b; }
    constexpr Angle half() const { return {turns >> 1}; }
};

consteval Angle operator""_deg(const char* digits) {
    // 2^32 / 360 is no integer: scale by 2^32 and divide once.
    const uint64_t scaled = parse_decimal(digits, uint64_t{1} << 32, uint64_t{360} << 32);
    return {static_cast<uint32_t>((scaled + 180) / 360)};
}
consteval Angle operator""_turn(const char* digits) {
    return {static_cast<uint32_t>(parse_decimal(digits, uint64_t{1} << 32, uint64_t{1} << 32))};
}

struct SinCos {
    Q30 sin, cos;
};

namespace detail {
/// 1 - xx/(k(k+1)) * (the next factor), Q31; the divisor is written as 2^32 / k(k+1).
SHADE16_INLINE constexpr uint32_t taylor_factor(uint32_t xx, uint32_t reciprocal, uint32_t next) {
    return (uint32_t{1} << 31) - mulhi(mulhi(xx, next), reciprocal);
}
/// The divisors of the series of sin(x)/x and of cos(x), the last factor first.
SHADE16_TABLE uint32_t sine_reciprocals[5] = {0x0253C825, 0x038E38E4, 0x06186186, 0x0CCCCCCD, 0x2AAAAAAB};
SHADE16_TABLE uint32_t cosine_reciprocals[5] = {0x02D82D83, 0x04924925, 0x08888889, 0x15555555, 0x80000000};
}  // namespace detail

inline constexpr Ulps sincos_max_error = 1.26_ulps;  // of Q30: 1.2e-9

/// sine and cosine.
/// Range   any angle.
/// Error   at most sincos_max_error; exact at multiples of a quarter turn.
/// Cost    17 high words and three long multiplies.
/// Source  Taylor series in Horner form on [-1/8, 1/8] turn, after folding by quarter turns.
SHADE16_ONCE constexpr SinCos sincos(Angle angle) {
    constexpr uint32_t pi_q30 = 0xC90FDAA2, one = uint32_t{1} << 31;
    const uint32_t quarter = (angle.turns + (uint32_t{1} << 29)) >> 30;
    const int32_t rest = static_cast<int32_t>(angle.turns - (quarter << 30));
    const int32_t x = static_cast<int32_t>(shift_right_round(multiply(rest, pi_q30), 30));  // radians, Q31
    const uint32_t xx = static_cast<uint32_t>(multiply(magnitude(x), magnitude(x)) >> 30);  // Q32, at most 0.617

    // Not a loop: on small cores each factor is a few instructions.
    const auto series = [xx](const uint32_t (&k)[5]) {
        const auto factor = [xx](uint32_t r, uint32_t next) { return detail::taylor_factor(xx, r, next); };
        return factor(k[4], factor(k[3], factor(k[2], factor(k[1], factor(k[0], one)))));
    };
    const uint32_t s = series(detail::sine_reciprocals), c = series(detail::cosine_reciprocals);
    const Q30 sine = Q30::from_raw(shift_right_round(multiply(x, s), 32));
    const Q30 cosine{static_cast<int32_t>((c + 1) >> 1)};

    switch (quarter & 3) {
        case 0: return {sine, cosine};
        case 1: return {cosine, -sine};
        case 2: return {-sine, -cosine};
        default: return {-cosine, sine};
    }
}
constexpr Q30 sin(Angle angle) { return sincos(angle).sin; }
constexpr Q30 cos(Angle angle) { return sincos(angle).cos; }

}  // namespace shade16
