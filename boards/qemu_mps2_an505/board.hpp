// MPS2 with image AN505: a Cortex-M33 in its secure state, with half the RAM. Its FPU stays off: the engine does not need one.
#pragma once

#include <boards/mps2.hpp>

namespace shade16 {

struct Board : Mps2 {
    static constexpr const char* name = "qemu_mps2_an505";
    static constexpr uint32_t cpu_hz = 20'000'000;
    static constexpr uint32_t ram_bytes = 2 * 1024 * 1024;
};

}  // namespace shade16
