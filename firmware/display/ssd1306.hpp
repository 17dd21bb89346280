// SSD1306 (Solomon Systech): a monochrome OLED of 128x64 or 128x32, here on an I2C bus.
// Source: SSD1306 data sheet, section 9, command table; the beginning is that of its application example and of u8g2.
#pragma once

#include <display/pages.hpp>

namespace shade16 {

/// A sink of Mono1 bands with a multiple of eight rows.
template <class I2c, int Height = 64, uint8_t Device = 0x3C>
class Ssd1306 {
    static_assert(Height == 64 || Height == 32, "the glass of an SSD1306 has 64 or 32 rows");

public:
    using Pixel = Mono1;
    static constexpr int width_px = 128, height_px = Height;

    static constexpr Wire wire(int bands) { return {static_cast<uint32_t>(6 * bands + width_px * height_px / 8) * i2c_bits_a_byte, I2c::hz}; }

    Ssd1306() {
        I2c::begin();
        for (const uint8_t byte : beginning) command(byte);
    }

    void flush(Area area, const uint8_t* pixels, size_t, bool) {
        const int32_t row_bytes = pixels_a_row<Mono1>(area.width);
        command(columns), command(static_cast<uint8_t>(area.x)), command(static_cast<uint8_t>(area.x + area.width - 1));
        command(pages), command(static_cast<uint8_t>(area.y / 8)), command(static_cast<uint8_t>((area.y + area.height) / 8 - 1));
        for (int32_t y = 0; y < area.height; y += 8)
            for (int32_t x = 0; x < area.width; ++x) I2c::send(Device, data_follows, page_byte(pixels + y * row_bytes, row_bytes, x));
    }
    void wait() {}

private:
    static constexpr uint8_t columns = 0x21, pages = 0x22, command_follows = 0x80, data_follows = 0x40;
    static constexpr uint8_t beginning[] = {
        0xAE,                           // off
        0xD5, 0x80, 0xA8, Height - 1,   // clock, rows
        0xD3, 0x00, 0x40,               // no offset
        0x8D, 0x14,                     // its own voltage
        0x20, 0x00,                     // columns first, then pages
        0xA1, 0xC8,                     // columns and rows run as on the glass
        0xDA, Height == 64 ? 0x12 : 0x02, 0x81, 0xCF, 0xD9, 0xF1, 0xDB, 0x40,
        0xA4, 0xA6, 0xAF,               // what memory holds, 1 is lit, on
    };

    static void command(uint8_t byte) { I2c::send(Device, command_follows, byte); }
};

}  // namespace shade16
