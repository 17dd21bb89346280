// A display of Adafruit_GFX's SPI family as a sink.   Adafruit_ST7789 tft(cs, dc, rst);  shade16::AdafruitSink sink(tft);
// Source: Adafruit_SPITFT.h (adafruit/Adafruit-GFX-Library, 1.11).
#pragma once

#include <Adafruit_SPITFT.h>
#include <shade16/shade16.hpp>

namespace shade16 {

class AdafruitSink {
public:
    using Pixel = Rgb565Swapped;
    explicit AdafruitSink(Adafruit_SPITFT& tft) : tft_(tft) {}

    /// The transaction stays open until the pixels are gone.
    void flush(Area a, const uint16_t* pixels, size_t bytes, bool) {
        wait();
        tft_.startWrite(), is_open_ = true;
        tft_.setAddrWindow(static_cast<uint16_t>(a.x), static_cast<uint16_t>(a.y), static_cast<uint16_t>(a.width), static_cast<uint16_t>(a.height));
        constexpr bool may_return_before = false, high_byte_first = true;
        tft_.writePixels(const_cast<uint16_t*>(pixels), static_cast<uint32_t>(bytes / 2), may_return_before, high_byte_first);
    }
    void wait() {
        if (!is_open_) return;
        tft_.dmaWait();
        tft_.endWrite(), is_open_ = false;
    }

private:
    Adafruit_SPITFT& tft_;
    bool is_open_ = false;
};

}  // namespace shade16
