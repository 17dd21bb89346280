// BBC micro:bit v1 (nRF51822, Cortex-M0): no 64-bit multiply, no divide, 16 KB of RAM.
#pragma once

#include <boards/small.hpp>

namespace shade16 {

struct Board : Small {
    static constexpr const char* name = "qemu_microbit";
    static constexpr uint32_t cpu_hz = 16'000'000;
    static constexpr uint32_t flash_bytes = 256 * 1024;
};

}  // namespace shade16
