// SSD0303 (Solomon Systech): a monochrome OLED of 132x64 memory, here behind a glass of 96x16, on an I2C bus.
// Source: SSD0303 data sheet, section 9, command table.
#pragma once

#include <display/pages.hpp>

namespace shade16 {

/// A sink of Mono1 bands with a multiple of eight rows.
template <class I2c, uint8_t Device = 0x3D, int FirstColumn = 36>
class Ssd0303 {
public:
    using Pixel = Mono1;
    static constexpr int width_px = 96, height_px = 16;

    static constexpr Wire wire(int) { return {static_cast<uint32_t>((3 + width_px) * height_px / 8) * i2c_bits_a_byte, I2c::hz}; }

    Ssd0303() {
        I2c::begin();
        for (const uint8_t byte : beginning) command(byte);
    }

    void flush(Area area, const uint8_t* pixels, size_t, bool) {
        const int32_t row_bytes = pixels_a_row<Mono1>(area.width);
        for (int32_t y = 0; y < area.height; y += 8) {
            const int32_t column = FirstColumn + area.x;
            command(static_cast<uint8_t>(page | (area.y + y) / 8));
            command(static_cast<uint8_t>(column_low | (column & 15)));
            command(static_cast<uint8_t>(column_high | column >> 4));
            for (int32_t x = 0; x < area.width; ++x) data(page_byte(pixels + y * row_bytes, row_bytes, x));
        }
    }
    void wait() {}

private:
    static constexpr uint8_t column_low = 0x00, column_high = 0x10, all_as_in_memory = 0xA4, not_inverted = 0xA6, off = 0xAE, on = 0xAF, page = 0xB0;
    static constexpr uint8_t beginning[] = {off, all_as_in_memory, not_inverted, on};
    static constexpr uint8_t command_follows = 0x80, data_follows = 0x40;

    static void command(uint8_t byte) { I2c::send(Device, command_follows, byte); }
    static void data(uint8_t byte) { I2c::send(Device, data_follows, byte); }
};

}  // namespace shade16
