// LovyanGFX and M5GFX as a sink.   LGFX lcd;  shade16::LovyanSink sink(lcd);  sink.begin();
// Source: LGFXBase.hpp (lovyan03/LovyanGFX, 1.1).
#pragma once

#include <LovyanGFX.hpp>
#include <shade16/shade16.hpp>

namespace shade16 {

class LovyanSink {
public:
    using Pixel = Rgb565Swapped;
    explicit LovyanSink(lgfx::LGFX_Device& lcd) : lcd_(lcd) {}

    void begin() {
        lcd_.initDMA();
        lcd_.startWrite();
    }
    /// The type of the pixels says that their bytes are exchanged already.
    void flush(Area a, const uint16_t* pixels, size_t, bool) {
        lcd_.pushImageDMA(a.x, a.y, a.width, a.height, reinterpret_cast<const lgfx::swap565_t*>(pixels));
    }
    void wait() { lcd_.waitDMA(); }

private:
    lgfx::LGFX_Device& lcd_;
};

}  // namespace shade16
