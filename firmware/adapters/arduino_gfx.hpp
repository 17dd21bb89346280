// Arduino_GFX as a sink.   Arduino_GFX* gfx = new Arduino_ST7789(...);  shade16::ArduinoGfxSink sink(*gfx);
// Source: Arduino_GFX.h (moononournation/Arduino_GFX, 1.4).
#pragma once

#include <Arduino_GFX_Library.h>
#include <shade16/shade16.hpp>

namespace shade16 {

class ArduinoGfxSink {
public:
    using Pixel = Rgb565Swapped;
    explicit ArduinoGfxSink(Arduino_GFX& gfx) : gfx_(gfx) {}

    /// Returns when the pixels are sent.
    void flush(Area a, const uint16_t* pixels, size_t, bool) {
        gfx_.draw16bitBeRGBBitmap(static_cast<int16_t>(a.x), static_cast<int16_t>(a.y), const_cast<uint16_t*>(pixels), static_cast<int16_t>(a.width), static_cast<int16_t>(a.height));
    }
    void wait() {}

private:
    Arduino_GFX& gfx_;
};

}  // namespace shade16
