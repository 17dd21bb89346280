// LVGL 9, both ways: a canvas that the engine draws into, and a driver of shade16 as LVGL's display.
//   shade16::LvglCanvas<240, 160> canvas;  canvas.begin(lv_canvas_create(parent));  canvas.show(renderer, frame);
//   shade16::LvglDisplay<Board::Panel>::attach(lv_display_create(240, 240), panel);
// Source: lv_canvas.h, lv_display.h (lvgl/lvgl, 9.3).
#pragma once

#include <lvgl.h>
#include <shade16/shade16.hpp>

namespace shade16 {

/// A canvas with memory of its own. `show` draws a frame and asks LVGL to copy it to the screen.
template <int32_t Width, int32_t Height, bool Depth = true>
class LvglCanvas {
public:
    void begin(lv_obj_t* canvas) {
        canvas_ = canvas;
        lv_canvas_set_buffer(canvas_, frame_.pixels, Width, Height, LV_COLOR_FORMAT_RGB565);
    }
    template <class AnyRenderer, class AnyFrame>
    void show(AnyRenderer& renderer, const AnyFrame& frame) {
        renderer.begin(frame, Viewport{Width, Height});
        renderer.draw(frame_.band());
        lv_obj_invalidate(canvas_);
    }

private:
    Framebuffer<Rgb565, Width, Height, Depth> frame_{};
    lv_obj_t* canvas_ = nullptr;
};

/// LVGL draws, a sink of shade16 shows. The sink's pixels are Rgb565Swapped or Rgb565, and LVGL is told.
template <class Panel>
struct LvglDisplay {
    static void attach(lv_display_t* display, Panel& panel) {
        constexpr bool swapped = Panel::Pixel::pack(0, 0, 1) != 1;
        lv_display_set_color_format(display, swapped ? LV_COLOR_FORMAT_RGB565_SWAPPED : LV_COLOR_FORMAT_RGB565);
        lv_display_set_user_data(display, &panel);
        lv_display_set_flush_cb(display, flush);
    }

private:
    /// The area's ends are inclusive; LVGL may draw over the pixels once it hears that they are flushed.
    static void flush(lv_display_t* display, const lv_area_t* area, uint8_t* pixels) {
        Panel& panel = *static_cast<Panel*>(lv_display_get_user_data(display));
        const Area a{area->x1, area->y1, area->x2 - area->x1 + 1, area->y2 - area->y1 + 1};
        panel.flush(a, reinterpret_cast<typename Panel::Pixel::Pixel*>(pixels), static_cast<size_t>(a.width * a.height) * 2, lv_display_flush_is_last(display));
        panel.wait();
        lv_display_flush_ready(display);
    }
};

}  // namespace shade16
