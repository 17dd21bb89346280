// A screen that shows a piece of memory: bands are copied to where it looks.
#pragma once

#include <shade16/shade16.hpp>

namespace shade16 {

/// A sink of bands for a screen of `Width` x `Height`. `Controller::begin(width, height)` switches it on and gives its memory.
template <class Controller, PixelFormat Format, int Width, int Height>
class ScreenMemory {
public:
    using Pixel = Format;
    static constexpr int width_px = Width, height_px = Height;

    ScreenMemory() : screen_(Controller::begin(Width, Height)) {}

    void flush(Area area, const typename Format::Pixel* pixels, size_t, bool) {
        for (int32_t y = 0; y < area.height; ++y)
            for (int32_t x = 0; x < area.width; ++x) screen_[(area.y + y) * Width + area.x + x] = *pixels++;
    }
    void wait() {}

private:
    volatile typename Format::Pixel* screen_;
};

}  // namespace shade16
