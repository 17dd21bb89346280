// A stub with the signatures of lovyan03/LovyanGFX 1.1.
#pragma once

#include "screen.hpp"

namespace lgfx {

struct swap565_t {
    uint16_t raw;
};

class LGFX_Device {
public:
    stub::Screen screen{};
    stub::Dma dma{&screen};
    bool has_begun = false;

    void initDMA() {}
    void startWrite(bool transaction = true) { has_begun = transaction; }
    template <typename T>
    void pushImageDMA(int32_t x, int32_t y, int32_t w, int32_t h, const T* data);
    void waitDMA() { dma.wait(); }
};

template <>
inline void LGFX_Device::pushImageDMA(int32_t x, int32_t y, int32_t w, int32_t h, const swap565_t* data) {
    if (!has_begun) screen.wrong = true;
    dma.wait();
    dma.start(x, y, w, h, data);
}

}  // namespace lgfx
