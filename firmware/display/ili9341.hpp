// ILI9341 (Ilitek): TFT of 240x320.
// Source: ILI9341 data sheet V1.11; the register values that are not in it are the ones that Adafruit, TFT_eSPI and LVGL all use.
#pragma once

#include <display/dcs.hpp>

namespace shade16 {

inline constexpr uint8_t ili9341_beginning[] = {
    dcs::reset, then_wait, 30,  // 150 ms
    0xEF, 3, 0x03, 0x80, 0x02,
    0xCF, 3, 0x00, 0xC1, 0x30,              // power control B
    0xED, 4, 0x64, 0x03, 0x12, 0x81,        // power on sequence
    0xE8, 3, 0x85, 0x00, 0x78,              // driver timing A
    0xCB, 5, 0x39, 0x2C, 0x00, 0x34, 0x02,  // power control A
    0xF7, 1, 0x20,                          // pump ratio
    0xEA, 2, 0x00, 0x00,                    // driver timing B
    0xC0, 1, 0x23,                          // power control 1
    0xC1, 1, 0x10,                          // power control 2
    0xC5, 2, 0x3E, 0x28,                    // VCOM 1
    0xC7, 1, 0x86,                          // VCOM 2
    0xB1, 2, 0x00, 0x18,                    // 79 frames a second
    0xB6, 3, 0x08, 0x82, 0x27,              // display function
    0xF2, 1, 0x00,                          // no three gammas
    0x26, 1, 0x01,                          // gamma curve 1
    0xE0, 15, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00,
    0xE1, 15, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F,
    dcs::sleep_out, then_wait, 24,  // 120 ms
};

inline constexpr DcsPanel ili9341{
    .name = "ili9341", .width_px = 240, .height_px = 320, .memory_width_px = 240, .memory_height_px = 320,
    .columns_mirrored = true, .blue_first = true,
    .beginning = ili9341_beginning, .beginning_bytes = sizeof(ili9341_beginning),
};

}  // namespace shade16
