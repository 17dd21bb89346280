// The STM32VLDISCOVERY, an STM32F100RB, as QEMU emulates it: 8 KB of RAM and no display.
#pragma once

#include <boards/small.hpp>

namespace shade16 {

struct Board : Small {
    static constexpr const char* name = "qemu_stm32vldiscovery";
    static constexpr uint32_t cpu_hz = 24'000'000;
    static constexpr uint32_t flash_bytes = 128 * 1024;
    static constexpr uint32_t ram_bytes = 8 * 1024;
};

}  // namespace shade16
