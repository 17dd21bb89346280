// Grey pixel formats: one channel, the luma.
#pragma once

#include "shade16/target/pixel.hpp"

namespace shade16 {

/// One byte a pixel.
struct Gray8 {
    using Pixel = uint8_t;
    static constexpr const char* name = "gray8";
    static constexpr int luma_bits = 8;
    static constexpr Pixel pack(uint32_t luma) { return static_cast<Pixel>(luma); }
};

/// Two pixels a byte, the left one in the high nibble: what SSD1322 and SSD0323 take. Rows begin on a byte.
struct Gray4 {
    using Pixel = uint8_t;
    static constexpr const char* name = "gray4";
    static constexpr int luma_bits = 4, pixels_a_byte_log2 = 1;
    static constexpr Pixel pack(uint32_t luma) { return static_cast<Pixel>(luma); }
};

/// Eight pixels a byte, row by row, the leftmost one in the highest bit, 1 being white: PBM's order (which has 1 for
/// black) and Linux' monochrome framebuffers'. Rows begin on a byte. A display of pages, as SSD1306, is its driver's matter.
struct Mono1 {
    using Pixel = uint8_t;
    static constexpr const char* name = "mono1";
    static constexpr int luma_bits = 1, pixels_a_byte_log2 = 3;
    static constexpr Pixel pack(uint32_t luma) { return static_cast<Pixel>(luma); }
};

}  // namespace shade16
