// Scaled: a mantissa and an exponent, for quantities of unknown magnitude: light intensity, attenuation, 1/z.
// A plain Q16 has no digits left for 1/z at z = 512 (4.7 px off) and none at all for a lamp of 10,000.
#pragma once

#include "shade16/num/literal.hpp"
#include "shade16/num/mulhi.hpp"

namespace shade16 {

inline constexpr int scaled_product_max_error_log2 = -32, scaled_sum_max_error_log2 = -31;  // relative

/// The number mantissa * 2^(exponent - 32), never negative. Normalised: the mantissa is 0 or has its top bit set.
/// Exponents are added with 32 bits, since an int has 16 on AVR.
struct Scaled {
    uint32_t mantissa = 0;
    int16_t exponent = 0;

    /// value * 2^exponent_of_bit_0, its mantissa rounded half up.
    /// Range   any value, exponents up to 2^30; 0 has one form, and exponents are held to 16 bits.  Error  scaled_product_max_error_log2.
    /// Cost    a count of zeros and a 64-bit shift.  Source  the top 32 bits, and the carry of their rounding.
    SHADE16_ONCE static constexpr Scaled normalized(uint64_t value, int32_t exponent_of_bit_0) {
        if (value == 0) return {};
        const int shift = 32 - leading_zeros(value);
        uint64_t mantissa = shift > 0 ? shift_right_round(value, shift) : value << -shift;
        int32_t exponent = exponent_of_bit_0 + shift + 32;
        if (mantissa >> 32) {  // rounding carried into the 33rd bit
            mantissa >>= 1;
            ++exponent;
        }
        return {static_cast<uint32_t>(mantissa), exponent};
    }

    constexpr Scaled() = default;
    constexpr Scaled(uint32_t m, int32_t e) : mantissa(m), exponent(static_cast<int16_t>(clamp<int32_t>(e, INT16_MIN, INT16_MAX))) {}
    consteval Scaled(int whole) {
        if (whole < 0) literal_is_out_of_range_for_its_type();
        *this = normalized(static_cast<uint64_t>(whole), 0);
    }

    constexpr bool is_zero() const { return mantissa == 0; }
    friend constexpr bool operator==(Scaled, Scaled) = default;

    /// The number with `fraction_bits` fraction bits, rounded down; UINT64_MAX when it does not fit.
    constexpr uint64_t to_fixed(int fraction_bits) const {
        const int32_t shift = int32_t{exponent} - 32 + fraction_bits;
        if (shift > 32) return mantissa == 0 ? 0 : UINT64_MAX;
        if (shift >= 0) return uint64_t{mantissa} << shift;
        return shift > -32 ? mantissa >> -shift : 0;
    }

    /// The sum.
    /// Range   any.  Error  scaled_sum_max_error_log2.  Cost  two 64-bit shifts and normalized.  Source  both aligned to the larger.
    friend constexpr Scaled operator+(Scaled a, Scaled b) {
        if (a.is_zero() || b.is_zero()) return a.is_zero() ? b : a;
        if (a.exponent < b.exponent) return b + a;
        const int32_t apart = min<int32_t>(int32_t{a.exponent} - b.exponent, 32);
        return normalized((uint64_t{a.mantissa} << 30) + (uint64_t{b.mantissa} << 30 >> apart), int32_t{a.exponent} - 62);
    }
    /// The product.
    /// Range   any.  Error  scaled_product_max_error_log2.  Cost  a long multiply and normalized.  Source  the product of the mantissas.
    friend constexpr Scaled operator*(Scaled a, Scaled b) {
        return normalized(multiply(a.mantissa, b.mantissa), int32_t{a.exponent} + b.exponent - 64);
    }
};

consteval Scaled operator""_scaled(const char* digits) {
    return Scaled::normalized(parse_decimal(digits, uint64_t{1} << 24, UINT64_MAX), -24);
}

}  // namespace shade16
