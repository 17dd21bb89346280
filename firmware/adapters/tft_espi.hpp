// TFT_eSPI as a sink.   TFT_eSPI tft;  shade16::TftEspiSink sink(tft);  sink.begin();
// Source: TFT_eSPI.h (Bodmer/TFT_eSPI, 2.5).
#pragma once

#include <TFT_eSPI.h>
#include <shade16/shade16.hpp>

namespace shade16 {

class TftEspiSink {
public:
    using Pixel = Rgb565Swapped;
    explicit TftEspiSink(TFT_eSPI& tft) : tft_(tft) {}

    /// After tft.init(). Its DMA exchanges the bytes of the caller's buffer if it is asked to: the pixels are in its order already.
    void begin() {
        tft_.setSwapBytes(false);
        tft_.initDMA();
        tft_.startWrite();
    }
    void flush(Area a, const uint16_t* pixels, size_t, bool) { tft_.pushImageDMA(a.x, a.y, a.width, a.height, const_cast<uint16_t*>(pixels)); }  // it only reads
    void wait() { tft_.dmaWait(); }

private:
    TFT_eSPI& tft_;
};

}  // namespace shade16
