// A stub with the signatures of lvgl/lvgl 9.3.
#pragma once

#include "screen.hpp"

typedef enum { LV_COLOR_FORMAT_RGB565 = 0x12, LV_COLOR_FORMAT_RGB565_SWAPPED = 0x1B } lv_color_format_t;
struct lv_area_t {
    int32_t x1, y1, x2, y2;
};
struct lv_obj_t {
    void* buffer;
    int32_t width, height;
    lv_color_format_t format;
    int invalidated;
};
inline void lv_canvas_set_buffer(lv_obj_t* canvas, void* buf, int32_t w, int32_t h, lv_color_format_t cf) { *canvas = {buf, w, h, cf, 0}; }
inline void lv_obj_invalidate(const lv_obj_t* obj) { ++const_cast<lv_obj_t*>(obj)->invalidated; }

struct lv_display_t;
typedef void (*lv_display_flush_cb_t)(lv_display_t*, const lv_area_t*, uint8_t*);
struct lv_display_t {
    lv_color_format_t format;
    void* user_data;
    lv_display_flush_cb_t flush;
    int ready;
    bool is_last;
};
inline void lv_display_set_color_format(lv_display_t* disp, lv_color_format_t format) { disp->format = format; }
inline void lv_display_set_user_data(lv_display_t* disp, void* data) { disp->user_data = data; }
inline void* lv_display_get_user_data(lv_display_t* disp) { return disp->user_data; }
inline void lv_display_set_flush_cb(lv_display_t* disp, lv_display_flush_cb_t flush) { disp->flush = flush; }
inline bool lv_display_flush_is_last(lv_display_t* disp) { return disp->is_last; }
inline void lv_display_flush_ready(lv_display_t* disp) { ++disp->ready; }
