// SiFive HiFive1 (FE310, RV32IMAC): 16 KB of RAM, code in a serial flash.
#pragma once

#include <boards/small.hpp>

namespace shade16 {

struct Board : Small {
    static constexpr const char* name = "qemu_sifive_e";
    static constexpr uint32_t cpu_hz = 16'000'000;
    static constexpr uint32_t flash_bytes = 12 * 1024 * 1024;
};

}  // namespace shade16
