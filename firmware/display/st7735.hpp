// ST7735R (Sitronix): TFT of 128x160 and smaller. The colour of the protective film's tab tells how the glass is wired.
// Source: ST7735R data sheet V0.2; frame rates, power and gamma are those that Adafruit and TFT_eSPI use.
#pragma once

#include <display/dcs.hpp>

namespace shade16 {

inline constexpr uint8_t st7735_beginning[] = {
    dcs::reset, then_wait, 30,                   // 150 ms
    dcs::sleep_out, then_wait, 100,              // 500 ms
    0xB1, 3, 0x01, 0x2C, 0x2D,                        // frame rates: normal, idle, partial
    0xB2, 3, 0x01, 0x2C, 0x2D,
    0xB3, 6, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D,
    0xB4, 1, 0x07,                                    // inversion of columns
    0xC0, 3, 0xA2, 0x02, 0x84,                        // power 1 to 5
    0xC1, 1, 0xC5,
    0xC2, 2, 0x0A, 0x00,
    0xC3, 2, 0x8A, 0x2A,
    0xC4, 2, 0x8A, 0xEE,
    0xC5, 1, 0x0E,                                    // VCOM
    0xE0, 16, 0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00, 0x01, 0x03, 0x10,
    0xE1, 16, 0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00, 0x00, 0x02, 0x10,
};

namespace detail {
struct St7735Glass {
    int width, height, memory_width, memory_height, first_column, first_row;
    bool blue_first, inverted;
};
constexpr DcsPanel st7735_panel(const char* name, const St7735Glass& g) {
    return {.name = name, .width_px = g.width, .height_px = g.height, .memory_width_px = g.memory_width, .memory_height_px = g.memory_height,
            .first_column = g.first_column, .first_row = g.first_row, .columns_mirrored = true, .rows_mirrored = true,
            .blue_first = g.blue_first, .inverted = g.inverted, .beginning = st7735_beginning, .beginning_bytes = sizeof(st7735_beginning)};
}
}  // namespace detail

inline constexpr DcsPanel st7735_black_tab = detail::st7735_panel("st7735_black_tab", {128, 160, 128, 160, 0, 0, false, false});
inline constexpr DcsPanel st7735_green_tab = detail::st7735_panel("st7735_green_tab", {128, 160, 132, 162, 2, 1, true, false});
inline constexpr DcsPanel st7735_128x128 = detail::st7735_panel("st7735_128x128", {128, 128, 132, 132, 2, 1, true, false});
inline constexpr DcsPanel st7735_80x160 = detail::st7735_panel("st7735_80x160", {80, 160, 128, 160, 24, 0, true, false});
inline constexpr DcsPanel st7735_80x160_plug_in = detail::st7735_panel("st7735_80x160_plug_in", {80, 160, 132, 162, 26, 1, true, true});

}  // namespace shade16
