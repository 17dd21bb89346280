// Arm's Versatile board (ARM926EJ-S) with a colour LCD of 320x240 pixels.
#pragma once

#include <boards/mps2.hpp>
#include <display/screen_memory.hpp>
#include <mcu/pl110.hpp>
#include <runtime/seen_on.hpp>

namespace shade16 {

struct Board : Mps2 {
    static constexpr const char* name = "qemu_versatilepb";
    static constexpr uint32_t cpu_hz = 24'000'000;

    using Panel = ScreenMemory<Pl110<width_px * height_px>, Rgb565, width_px, height_px>;
    SeenOn<Panel> display;
};

}  // namespace shade16
