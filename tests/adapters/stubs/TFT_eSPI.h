// A stub with the signatures of Bodmer/TFT_eSPI 2.5.
#pragma once

#include "screen.hpp"

class TFT_eSPI {
public:
    stub::Screen screen{};
    stub::Dma dma{&screen};
    bool swaps = true, has_dma = false, has_begun = false;

    bool initDMA(bool ctrl_cs = false) { return has_dma = !ctrl_cs; }
    void startWrite() { has_begun = true; }
    void setSwapBytes(bool swap) { swaps = swap; }
    void pushImageDMA(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t* data, uint16_t* buffer = nullptr) {
        if (!has_dma || !has_begun || buffer != nullptr || swaps) screen.wrong = true;  // swapping would write to the band
        dma.wait();
        dma.start(x, y, w, h, data);
    }
    void dmaWait() { dma.wait(); }
};
