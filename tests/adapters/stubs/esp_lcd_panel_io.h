// A stub with the signatures of espressif/esp-idf 5.1.
#pragma once

#include "screen.hpp"

typedef int esp_err_t;
#define ESP_OK 0
struct esp_lcd_panel_io_t;
typedef esp_lcd_panel_io_t* esp_lcd_panel_io_handle_t;
struct esp_lcd_panel_io_event_data_t {};
typedef bool (*esp_lcd_panel_io_color_trans_done_cb_t)(esp_lcd_panel_io_handle_t, esp_lcd_panel_io_event_data_t*, void*);
struct esp_lcd_panel_io_callbacks_t {
    esp_lcd_panel_io_color_trans_done_cb_t on_color_trans_done;
};
struct esp_lcd_panel_io_t {
    esp_lcd_panel_io_callbacks_t callbacks;
    void* context;
};
inline esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t io, const esp_lcd_panel_io_callbacks_t* callbacks, void* context) {
    io->callbacks = *callbacks, io->context = context;
    return ESP_OK;
}
