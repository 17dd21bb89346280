// Zephyr's display API as a sink.   shade16::ZephyrSink sink(DEVICE_DT_GET(DT_CHOSEN(zephyr_display)));
// Source: zephyr/drivers/display.h (Zephyr, 3.7 to 4.2): RGB_565 displays take the high byte first, the pitch is in pixels.
#pragma once

#include <shade16/shade16.hpp>
#include <zephyr/drivers/display.h>

namespace shade16 {

class ZephyrSink {
public:
    using Pixel = Rgb565Swapped;
    explicit ZephyrSink(const device* display) : display_(display) {}

    /// Returns when the pixels are sent. `failed` remembers that a write was refused.
    void flush(Area a, const uint16_t* pixels, size_t bytes, bool last) {
        display_buffer_descriptor band{};
        band.buf_size = static_cast<uint32_t>(bytes);
        band.width = band.pitch = static_cast<uint16_t>(a.width);
        band.height = static_cast<uint16_t>(a.height);
        band.frame_incomplete = !last;
        if (display_write(display_, static_cast<uint16_t>(a.x), static_cast<uint16_t>(a.y), &band, pixels) != 0) failed_ = true;
    }
    void wait() {}
    bool failed() const { return failed_; }

private:
    const device* display_;
    bool failed_ = false;
};

}  // namespace shade16
