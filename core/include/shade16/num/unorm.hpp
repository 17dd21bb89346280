// Unorm16: unsigned 16 bits, 65535 = 1.0. Material, light and vertex colours.
#pragma once

#include "shade16/num/literal.hpp"

namespace shade16 {

struct Unorm16 {
    uint16_t raw = 0;

    static constexpr uint16_t one = 65535;
    static constexpr Unorm16 from_raw(uint32_t raw) { return {static_cast<uint16_t>(min<uint32_t>(raw, one))}; }
    /// An 8-bit code, exactly: 255 is 1.0 in both.
    static constexpr Unorm16 from_code8(uint32_t code) { return from_raw(min<uint32_t>(code, 255) * 257); }
    /// The same number with 32 bits, 2^32 - 1 = 1.0: exact, and read as a Q32 fraction it is at most 2^-32 low.
    constexpr uint32_t widened() const { return uint32_t{raw} * 65537; }
    friend constexpr bool operator==(Unorm16, Unorm16) = default;
};

consteval Unorm16 operator""_unorm(const char* digits) {
    return {static_cast<uint16_t>(parse_decimal(digits, Unorm16::one, Unorm16::one))};
}

/// A colour; linear arithmetic on display codes, as the fixed-function pipeline had it.
struct Rgb {
    Unorm16 r, g, b;
    friend constexpr bool operator==(Rgb, Rgb) = default;
};

/// A colour as a factor: Q32, at most 2^-32 low.
struct ColorFactor {
    uint32_t r = 0, g = 0, b = 0;
    constexpr ColorFactor() = default;
    constexpr ColorFactor(uint32_t red, uint32_t green, uint32_t blue) : r(red), g(green), b(blue) {}
    constexpr ColorFactor(Rgb c) : r(c.r.widened()), g(c.g.widened()), b(c.b.widened()) {}
};

inline constexpr Rgb black{};
inline constexpr Rgb white{{Unorm16::one}, {Unorm16::one}, {Unorm16::one}};

/// rgb(0xFF8855): the three bytes of a hexadecimal colour.
constexpr Rgb rgb(uint32_t hex) {
    return {Unorm16::from_code8((hex >> 16) & 255), Unorm16::from_code8((hex >> 8) & 255), Unorm16::from_code8(hex & 255)};
}

}  // namespace shade16
