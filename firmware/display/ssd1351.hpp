// SSD1351 (Solomon Systech): a colour OLED of 128x128.
// Source: SSD1351 data sheet, section 8, command table; the beginning is that of TFT_eSPI and fbcp-ili9341.
#pragma once

#include <display/dcs.hpp>

namespace shade16 {

namespace ssd1351 {
inline constexpr uint8_t columns = 0x15, rows = 0x75, write_memory = 0x5C, remap = 0xA0;
inline constexpr uint8_t beginning[] = {
    0xFD, 1, 0x12, 0xFD, 1, 0xB1,              // unlocked
    0xAE, 0,                                   // off
    0xB3, 1, 0xF1, 0xCA, 1, 127,               // clock, rows
    remap, 1, 0x74,                            // 65536 colours, COM lines split, rows run up
    0xA1, 1, 0x00, 0xA2, 1, 0x00,              // no offset
    0xB5, 1, 0x00, 0xAB, 1, 0x01,              // lines, voltage
    0xB1, 1, 0x32, 0xBE, 1, 0x05,              // charge, COM voltage
    0xC1, 3, 0xC8, 0x80, 0xC8, 0xC7, 1, 0x0F,  // contrast
    0xB4, 3, 0xA0, 0xB5, 0x55, 0xB6, 1, 0x01,
    0xA6, 0, 0xAF, 0,                          // what memory holds, on
};
}  // namespace ssd1351

/// A sink of bands. The controller goes on where it was when it is told to write again, so that every band brings its window.
template <DisplayBus Bus>
class Ssd1351 {
public:
    using Pixel = typename Bus::Format;
    static constexpr int width_px = 128, height_px = 128;

    static constexpr Wire wire(int bands) { return {static_cast<uint32_t>(8 * 7 * bands + 16 * width_px * height_px), Bus::bus_hz}; }

    constexpr explicit Ssd1351(Bus bus = {}) : bus_(bus) {
        bus_.reset();
        run_commands(bus_, ssd1351::beginning, sizeof(ssd1351::beginning));
    }

    constexpr void flush(Area area, const typename Pixel::Pixel* pixels, size_t bytes, bool) {
        window(ssd1351::columns, area.x, area.width);
        window(ssd1351::rows, area.y, area.height);
        bus_.command(ssd1351::write_memory);
        bus_.pixels(pixels, bytes / sizeof(*pixels));
    }
    constexpr void wait() { bus_.wait(); }

private:
    constexpr void window(uint8_t command, int first, int count) {
        const uint8_t ends[2] = {static_cast<uint8_t>(first), static_cast<uint8_t>(first + count - 1)};
        bus_.command(command);
        bus_.data(ends, 2);
    }

    Bus bus_;
};

}  // namespace shade16
