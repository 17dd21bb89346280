// A stub with the signatures of moononournation/Arduino_GFX 1.4.
#pragma once

#include "screen.hpp"

class Arduino_GFX {
public:
    stub::Screen screen{};
    virtual ~Arduino_GFX() = default;
    virtual void draw16bitBeRGBBitmap(int16_t x, int16_t y, uint16_t* bitmap, int16_t w, int16_t h) { screen.put(x, y, w, h, bitmap); }
};
