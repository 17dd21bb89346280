// PL110, the colour LCD controller of Arm's Versatile board: RGB565 from RAM.
// Source: PrimeCell Color LCD Controller (PL110) TRM, Arm; Versatile Application Baseboard for ARM926EJ-S User Guide, Arm.
#pragma once

#include <mcu/registers.hpp>

namespace shade16 {

template <uint32_t MostPixels, class Port = Registers>
struct Pl110 {
    static volatile uint16_t* begin(int width, int height) {
        Port::write(system_lcd_control, 0);
        Port::write(horizontal, (static_cast<uint32_t>(width) / 16 - 1) << 2);
        Port::write(vertical, static_cast<uint32_t>(height) - 1);
        Port::write(more_timing, 0);
        Port::write(upper_panel, static_cast<uint32_t>(reinterpret_cast<uintptr_t>(memory)));
        Port::write(interrupts, 0);
        Port::write(control, enabled | sixteen_bits | thin_film | blue_in_low_bits | powered);
        return memory;
    }

private:
    static constexpr uint32_t system_lcd_control = 0x10000050, base = 0x10120000;
    // The Versatile board has the last two the other way round than the PL110's manual.
    static constexpr uint32_t horizontal = base, vertical = base + 4, more_timing = base + 8, upper_panel = base + 0x10, control = base + 0x18, interrupts = base + 0x1C;
    static constexpr uint32_t enabled = 1, sixteen_bits = 4 << 1, thin_film = 1 << 5, blue_in_low_bits = 1 << 8, powered = 1 << 11;
    static inline volatile uint16_t memory[MostPixels] __attribute__((aligned(64)));
};

}  // namespace shade16
