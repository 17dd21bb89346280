// A stub with the signatures of adafruit/Adafruit-GFX-Library 1.11.
#pragma once

#include "screen.hpp"

class Adafruit_SPITFT {
public:
    stub::Screen screen{};
    stub::Dma dma{&screen};
    bool is_open = false;
    int x = 0, y = 0, w = 0, h = 0;

    virtual ~Adafruit_SPITFT() = default;
    void startWrite() {
        if (is_open) screen.wrong = true;
        is_open = true;
    }
    void endWrite() {
        if (!is_open || dma.pixels != nullptr) screen.wrong = true;
        is_open = false;
    }
    virtual void setAddrWindow(uint16_t x0, uint16_t y0, uint16_t width, uint16_t height) { x = x0, y = y0, w = width, h = height; }
    void writePixels(uint16_t* colors, uint32_t len, bool block = true, bool bigEndian = false) {
        if (!is_open || block || !bigEndian || len != static_cast<uint32_t>(w * h)) screen.wrong = true;
        dma.start(x, y, w, h, colors);
    }
    void dmaWait() { dma.wait(); }
};
