// ST7789V (Sitronix): IPS glass of 240x320, 240x240 or 135x240 before a memory of 240x320.
// Source: ST7789V data sheet; power, VCOM and gate values are its defaults for 240x320, as LVGL and TFT_eSPI set them.
#pragma once

#include <display/dcs.hpp>

namespace shade16 {

inline constexpr uint8_t st7789_beginning[] = {
    dcs::reset, then_wait, 30,      // 150 ms
    dcs::sleep_out, then_wait, 24,  // 120 ms
    0xB0, 2, 0x00, 0xC0,                 // five bits become six by repeating the highest, so that grey has no tint
    0xB7, 1, 0x35,                       // gate voltages
    0xBB, 1, 0x28,                       // VCOM
    0xC0, 1, 0x0C,                       // power
    0xC2, 2, 0x01, 0xFF,
    0xC3, 1, 0x10,
    0xC4, 1, 0x20,
    0xC6, 1, 0x0F,  // 60 frames a second
    0xD0, 2, 0xA4, 0xA1,
};

namespace detail {
constexpr DcsPanel st7789_glass(const char* name, int width, int height, int first_column, int first_row) {
    return {.name = name, .width_px = width, .height_px = height, .memory_width_px = 240, .memory_height_px = 320,
            .first_column = first_column, .first_row = first_row, .columns_mirrored = true, .rows_mirrored = true,
            .inverted = true, .beginning = st7789_beginning, .beginning_bytes = sizeof(st7789_beginning)};
}
}  // namespace detail

inline constexpr DcsPanel st7789 = detail::st7789_glass("st7789", 240, 320, 0, 0);
inline constexpr DcsPanel st7789_240x240 = detail::st7789_glass("st7789_240x240", 240, 240, 0, 0);
inline constexpr DcsPanel st7789_135x240 = detail::st7789_glass("st7789_135x240", 135, 240, 52, 40);

}  // namespace shade16
