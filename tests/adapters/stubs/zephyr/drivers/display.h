// A stub with the signatures of Zephyr 3.7.
#pragma once

#include "../../screen.hpp"

struct device {
    stub::Screen* screen;
    int frames;
};
struct display_buffer_descriptor {
    uint32_t buf_size;
    uint16_t width, height, pitch;
    bool frame_incomplete;
};
inline int display_write(const device* dev, const uint16_t x, const uint16_t y, const display_buffer_descriptor* desc, const void* buf) {
    if (desc->pitch != desc->width || desc->buf_size != 2u * desc->width * desc->height) return -22;
    dev->screen->put(x, y, desc->width, desc->height, buf);
    if (!desc->frame_incomplete) ++const_cast<device*>(dev)->frames;
    return 0;
}
