// Decimal literals parsed digit by digit: the core has no floating point, also not at compile time.
#pragma once

#include "shade16/num/bits.hpp"

namespace shade16 {

/// Never defined: a literal that reaches one of these does not compile, and the name is the message.
void literal_has_a_character_that_is_neither_a_digit_nor_a_point();
void literal_is_out_of_range_for_its_type();

/// round(text * scale), half up, for `12`, `12.5` and `1'000.25`; digits after the ninth decimal are ignored.
/// Range   up to `limit`, else it does not compile.
/// Error   half a unit; with more than nine decimals up to scale * 1e-9 more.  Cost  none: while compiling.  Source  digit by digit.
/// Clang 14 calls the literals of a template's body at run time, and does not link: name them as constexpr variables.
consteval uint64_t parse_decimal(const char* text, uint64_t scale, uint64_t limit) {
    uint64_t whole = 0, fraction = 0, unit = 1;
    bool after_point = false;
    for (; *text != 0; ++text) {
        if (*text == '\'') continue;
        if (*text == '.') {
            after_point = true;
            continue;
        }
        if (*text < '0' || *text > '9') literal_has_a_character_that_is_neither_a_digit_nor_a_point();
        const uint64_t digit = static_cast<uint64_t>(*text - '0');
        if (!after_point) {
            whole = whole * 10 + digit;
            if (whole > UINT32_MAX) literal_is_out_of_range_for_its_type();
        } else if (unit < 1'000'000'000) {
            fraction = fraction * 10 + digit;
            unit *= 10;
        }
    }
    const uint64_t value = whole * scale + (fraction * scale + unit / 2) / unit;
    if (value > limit) literal_is_out_of_range_for_its_type();
    return value;
}

}  // namespace shade16
