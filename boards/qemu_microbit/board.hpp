// BBC micro:bit v1 (nRF51822, Cortex-M0): no 64-bit multiply, no divide, 16 KB of RAM. What runs here runs anywhere.
#pragma once

#include <shade16/shade16.hpp>

namespace shade16 {

struct Board {
    static constexpr const char* name = "qemu_microbit";
    static constexpr uint32_t cpu_hz = 16'000'000;
    static constexpr uint32_t flash_bytes = 256 * 1024;
    static constexpr uint32_t ram_bytes = 16 * 1024;

    using Pixel = Rgb565;
    static constexpr int width_px = 128;
    static constexpr int height_px = 64;
    static constexpr int band_rows = 8;
};

}  // namespace shade16
