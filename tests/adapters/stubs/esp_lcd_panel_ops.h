// A stub with the signatures of espressif/esp-idf 5.1. The transfer is over before the call returns, as an interrupt may have it.
#pragma once

#include "esp_lcd_panel_io.h"

struct esp_lcd_panel_t {
    stub::Screen screen{};
    esp_lcd_panel_io_t* io = nullptr;
};
typedef esp_lcd_panel_t* esp_lcd_panel_handle_t;
inline esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end, int y_end, const void* color_data) {
    if (x_start >= x_end || y_start >= y_end || x_end > panel->screen.width || y_end > panel->screen.height) return 0x102;  // ESP_ERR_INVALID_ARG
    panel->screen.put(x_start, y_start, x_end - x_start, y_end - y_start, color_data);
    panel->io->callbacks.on_color_trans_done(panel->io, nullptr, panel->io->context);
    return ESP_OK;
}
