// QEMU's RISC-V machine `virt` with RV32IMAC code: the memory of the MPS2 boards and QEMU's plainest display card.
#pragma once

#include <boards/mps2.hpp>
#include <display/screen_memory.hpp>
#include <mcu/bochs_display.hpp>
#include <runtime/seen_on.hpp>

namespace shade16 {

struct Board : Mps2 {
    static constexpr const char* name = "qemu_riscv_virt";
    static constexpr uint32_t cpu_hz = 10'000'000;

    using Panel = ScreenMemory<BochsDisplay<>, Rgb565, width_px, height_px>;
    SeenOn<Panel> display;
};

}  // namespace shade16
