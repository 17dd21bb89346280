// ST7735R (Sitronix): TFT of 128x160 and smaller. The colour of the protective film's tab tells how the glass is wired.
// Source: ST7735R data sheet V0.2; frame rates, power and gamma are those that Adafruit and TFT_eSPI use.
// Made by scripts/boards.sh of boards/panels/st7735*.txt, which says what the commands do.
#pragma once

#include <display/dcs.hpp>

namespace shade16 {

inline constexpr uint8_t st7735_beginning[] = {
    0x01, then_wait, 30,
    0x11, then_wait, 100,
    0xB1, 3, 0x01, 0x2C, 0x2D,
    0xB2, 3, 0x01, 0x2C, 0x2D,
    0xB3, 6, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D,
    0xB4, 1, 0x07,
    0xC0, 3, 0xA2, 0x02, 0x84,
    0xC1, 1, 0xC5,
    0xC2, 2, 0x0A, 0x00,
    0xC3, 2, 0x8A, 0x2A,
    0xC4, 2, 0x8A, 0xEE,
    0xC5, 1, 0x0E,
    0xE0, 16, 0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00, 0x01, 0x03, 0x10,
    0xE1, 16, 0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00, 0x00, 0x02, 0x10,
};

inline constexpr DcsPanel st7735_black_tab{
    .name = "st7735_black_tab", .width_px = 128, .height_px = 160, .memory_width_px = 128, .memory_height_px = 160,
    .columns_mirrored = true, .rows_mirrored = true, .beginning = st7735_beginning, .beginning_bytes = sizeof(st7735_beginning),
};

// Square glass, 1.44 inches.
inline constexpr DcsPanel st7735_128x128{
    .name = "st7735_128x128", .width_px = 128, .height_px = 128, .memory_width_px = 132, .memory_height_px = 132, .first_column = 2,
    .first_row = 1, .columns_mirrored = true, .rows_mirrored = true, .blue_first = true, .beginning = st7735_beginning,
    .beginning_bytes = sizeof(st7735_beginning),
};

// Narrow glass, 0.96 inches.
inline constexpr DcsPanel st7735_80x160{
    .name = "st7735_80x160", .width_px = 80, .height_px = 160, .memory_width_px = 128, .memory_height_px = 160, .first_column = 24,
    .columns_mirrored = true, .rows_mirrored = true, .blue_first = true, .beginning = st7735_beginning,
    .beginning_bytes = sizeof(st7735_beginning),
};

// Narrow glass on a plug-in film: IPS, and wired to other columns.
inline constexpr DcsPanel st7735_80x160_plug_in{
    .name = "st7735_80x160_plug_in", .width_px = 80, .height_px = 160, .memory_width_px = 132, .memory_height_px = 162,
    .first_column = 26, .first_row = 1, .columns_mirrored = true, .rows_mirrored = true, .blue_first = true, .inverted = true,
    .beginning = st7735_beginning, .beginning_bytes = sizeof(st7735_beginning),
};

// A memory larger than the glass.
inline constexpr DcsPanel st7735_green_tab{
    .name = "st7735_green_tab", .width_px = 128, .height_px = 160, .memory_width_px = 132, .memory_height_px = 162, .first_column = 2,
    .first_row = 1, .columns_mirrored = true, .rows_mirrored = true, .blue_first = true, .beginning = st7735_beginning,
    .beginning_bytes = sizeof(st7735_beginning),
};

}  // namespace shade16
