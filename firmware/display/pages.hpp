// Monochrome controllers keep a byte for eight pixels below each other, the highest in bit 0: a page is eight rows of such bytes.
#pragma once

#include <display/wire.hpp>

namespace shade16 {

/// A byte for a display on an I2C bus: start, address, control byte and itself with a bit each that acknowledges, stop.
inline constexpr uint32_t i2c_bits_a_byte = 1 + 3 * 9 + 1;

/// Eight rows of a Mono1 band, from `rows` on, as the byte of column x.
constexpr uint8_t page_byte(const uint8_t* rows, int32_t row_bytes, int32_t x) {
    unsigned column = 0;
    for (int32_t y = 0; y < 8; ++y) column |= (unsigned{rows[y * row_bytes + (x >> 3)]} >> (7 - (x & 7)) & 1u) << y;
    return static_cast<uint8_t>(column);
}

}  // namespace shade16
