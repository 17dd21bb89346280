// The ESP8266's processor (Xtensa LX106) as QEMU's simulator board has it, with as much RAM as an ESP8266 leaves to a program.
#pragma once

#include <boards/small.hpp>

namespace shade16 {

struct Board : Small {
    static constexpr const char* name = "qemu_lx106";
    static constexpr uint32_t cpu_hz = 80'000'000;
    static constexpr uint32_t flash_bytes = 1024 * 1024;
    static constexpr uint32_t ram_bytes = 64 * 1024;
};

}  // namespace shade16
