// ESP-IDF's esp_lcd as a sink.   shade16::EspLcdSink sink(panel);  sink.begin(io);
// Bands must be in memory that DMA reaches: MALLOC_CAP_DMA, or internal RAM.
// Source: esp_lcd_panel_ops.h, esp_lcd_panel_io.h (espressif/esp-idf, 5.1).
#pragma once

#include <esp_lcd_panel_io.h>
#include <esp_lcd_panel_ops.h>
#include <shade16/shade16.hpp>

namespace shade16 {

class EspLcdSink {
public:
    using Pixel = Rgb565Swapped;
    explicit EspLcdSink(esp_lcd_panel_handle_t panel) : panel_(panel) {}
    EspLcdSink(const EspLcdSink&) = delete;
    EspLcdSink& operator=(const EspLcdSink&) = delete;

    /// Hears of sent bands from the panel's bus.
    void begin(esp_lcd_panel_io_handle_t io) {
        esp_lcd_panel_io_callbacks_t callbacks{};
        callbacks.on_color_trans_done = sent;
        esp_lcd_panel_io_register_event_callbacks(io, &callbacks, this);
    }
    /// The area's end is exclusive. `failed` remembers that a band was refused.
    void flush(Area a, const uint16_t* pixels, size_t, bool) {
        in_flight_ = true;
        if (esp_lcd_panel_draw_bitmap(panel_, a.x, a.y, a.x + a.width, a.y + a.height, pixels) != ESP_OK) in_flight_ = false, failed_ = true;
    }
    void wait() {
        while (in_flight_) {}
    }
    bool failed() const { return failed_; }

private:
    static bool sent(esp_lcd_panel_io_handle_t, esp_lcd_panel_io_event_data_t*, void* self) {
        static_cast<EspLcdSink*>(self)->in_flight_ = false;
        return false;  // no task was woken
    }

    esp_lcd_panel_handle_t panel_;
    volatile bool in_flight_ = false;
    bool failed_ = false;
};

}  // namespace shade16
