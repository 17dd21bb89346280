// ST7789V (Sitronix): IPS glass of 240x320, 240x240 or 135x240 before a memory of 240x320.
// Source: ST7789V data sheet; power, VCOM and gate values are its defaults for 240x320, as LVGL and TFT_eSPI set them.
// Made by scripts/boards.sh of boards/panels/st7789*.txt, which says what the commands do.
#pragma once

#include <display/dcs.hpp>

namespace shade16 {

inline constexpr uint8_t st7789_beginning[] = {
    0x01, then_wait, 30,
    0x11, then_wait, 24,
    0xB0, 2, 0x00, 0xC0,
    0xB7, 1, 0x35,
    0xBB, 1, 0x28,
    0xC0, 1, 0x0C,
    0xC2, 2, 0x01, 0xFF,
    0xC3, 1, 0x10,
    0xC4, 1, 0x20,
    0xC6, 1, 0x0F,
    0xD0, 2, 0xA4, 0xA1,
};

inline constexpr DcsPanel st7789{
    .name = "st7789", .width_px = 240, .height_px = 320, .memory_width_px = 240, .memory_height_px = 320, .columns_mirrored = true,
    .rows_mirrored = true, .inverted = true, .beginning = st7789_beginning, .beginning_bytes = sizeof(st7789_beginning),
};

// Narrow glass before the middle of the memory, one column nearer to one side.
inline constexpr DcsPanel st7789_135x240{
    .name = "st7789_135x240", .width_px = 135, .height_px = 240, .memory_width_px = 240, .memory_height_px = 320, .first_column = 52,
    .first_row = 40, .columns_mirrored = true, .rows_mirrored = true, .inverted = true, .beginning = st7789_beginning,
    .beginning_bytes = sizeof(st7789_beginning),
};

// Square glass before the first 240 rows of the memory, which are its last ones as the upright picture counts them.
inline constexpr DcsPanel st7789_240x240{
    .name = "st7789_240x240", .width_px = 240, .height_px = 240, .memory_width_px = 240, .memory_height_px = 320,
    .columns_mirrored = true, .rows_mirrored = true, .inverted = true, .beginning = st7789_beginning,
    .beginning_bytes = sizeof(st7789_beginning),
};

}  // namespace shade16
