// Q16: signed 32 bits, 16 of them fraction (s15.16, OpenGL ES GLfixed). Positions, matrices, distances.
#pragma once

#include "shade16/num/literal.hpp"
#include "shade16/num/mulhi.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16 {

inline constexpr Ulps q16_product_max_error = 0.5_ulps;

/// A number in [-32768, 32768) in steps of 2^-16. Whole literals convert by themselves, fractions are written 1.5_q16.
/// A value only known at run time comes in through from_raw or from_int: nothing converts silently.
/// Out of range: every operation returns the nearest representable value. There is no operator/: see reciprocal.hpp.
struct Q16 {
    int32_t raw = 0;

    constexpr Q16() = default;
    consteval Q16(int whole) : raw(static_cast<int32_t>(int64_t{whole} * 65536)) {
        if (whole < -32768 || whole > 32767) literal_is_out_of_range_for_its_type();
    }
    static constexpr Q16 from_raw(int32_t raw) {
        Q16 value;
        value.raw = raw;
        return value;
    }
    static constexpr Q16 from_int(int32_t whole) { return from_raw(saturate(int64_t{whole} * 65536)); }

    friend constexpr bool operator==(Q16, Q16) = default;
    friend constexpr bool operator<(Q16 a, Q16 b) { return a.raw < b.raw; }
    friend constexpr bool operator>(Q16 a, Q16 b) { return b < a; }
    friend constexpr bool operator<=(Q16 a, Q16 b) { return !(b < a); }
    friend constexpr bool operator>=(Q16 a, Q16 b) { return !(a < b); }

    friend constexpr Q16 operator+(Q16 a, Q16 b) { return from_raw(saturate(int64_t{a.raw} + b.raw)); }
    friend constexpr Q16 operator-(Q16 a, Q16 b) { return from_raw(saturate(int64_t{a.raw} - b.raw)); }
    friend constexpr Q16 operator-(Q16 a) { return from_raw(saturate(-int64_t{a.raw})); }

    /// The product, rounded half up.
    /// Range   any; saturates.  Error  q16_product_max_error, proved in tests/proof.
    /// Cost    one long multiply; on M0+ four short ones.  Source  the whole product, rounded half up.
    friend constexpr Q16 operator*(Q16 a, Q16 b) {
        return from_raw(saturate(shift_right_round(multiply(a.raw, b.raw), 16)));
    }

    friend constexpr Q16& operator+=(Q16& a, Q16 b) { return a = a + b; }
    friend constexpr Q16& operator-=(Q16& a, Q16 b) { return a = a - b; }
    friend constexpr Q16& operator*=(Q16& a, Q16 b) { return a = a * b; }
};

consteval Q16 operator""_q16(const char* digits) {
    return Q16::from_raw(static_cast<int32_t>(parse_decimal(digits, 65536, INT32_MAX)));
}

}  // namespace shade16
