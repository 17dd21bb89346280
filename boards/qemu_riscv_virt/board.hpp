// QEMU's RISC-V machine `virt` with RV32IMAC code: the same memory and screen as the MPS2 boards.
#pragma once

#include <boards/mps2.hpp>

namespace shade16 {

struct Board : Mps2 {
    static constexpr const char* name = "qemu_riscv_virt";
    static constexpr uint32_t cpu_hz = 10'000'000;
};

}  // namespace shade16
