// SSD0323 (Solomon Systech): an OLED of 128x64 pixels in 16 greys, on a four-wire SPI bus.
// Source: SSD0323 data sheet, section 9, command table.
#pragma once

#include <display/wire.hpp>

namespace shade16 {

/// A sink of Gray4 bands. `Spi` sends a byte and returns when it is on the wire; `DataLine` is D/C#, `SelectLine` the chip's select.
template <class Spi, class DataLine, class SelectLine>
class Ssd0323 {
public:
    using Pixel = Gray4;
    static constexpr int width_px = 128, height_px = 64;

    static constexpr Wire wire(int bands) { return {static_cast<uint32_t>(8 * 6 * bands + 4 * width_px * height_px), Spi::hz}; }

    Ssd0323() {
        Spi::begin(), DataLine::begin(), SelectLine::begin();
        SelectLine::set(true);
        for (const uint8_t byte : beginning) command(byte);
    }

    void flush(Area area, const uint8_t* pixels, size_t bytes, bool) {
        command(column_addresses), command(static_cast<uint8_t>(area.x / 2)), command(static_cast<uint8_t>((area.x + area.width) / 2 - 1));
        command(row_addresses), command(static_cast<uint8_t>(area.y)), command(static_cast<uint8_t>(area.y + area.height - 1));
        DataLine::set(true);
        for (size_t i = 0; i < bytes; ++i) Spi::send(pixels[i]);
    }
    void wait() {}

private:
    static constexpr uint8_t column_addresses = 0x15, row_addresses = 0x75, remap = 0xA0, all_as_in_memory = 0xA4, on = 0xAF;
    /// The left pixel in the high nibble, columns first, even and odd COM lines split.
    static constexpr uint8_t beginning[] = {remap, 0x52, all_as_in_memory, on};

    static void command(uint8_t byte) {
        DataLine::set(false);
        Spi::send(byte);
    }
};

}  // namespace shade16
