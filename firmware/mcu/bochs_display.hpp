// QEMU's `bochs-display` on the PCI bus of its RISC-V machine `virt`: RGB565 from the card's memory.
// Source: QEMU documentation, "PCI IDs for QEMU" and "QEMU Standard VGA".
#pragma once

#include <mcu/registers.hpp>
#include <runtime/console.hpp>

namespace shade16 {

template <class Port = Registers>
struct BochsDisplay {
    static volatile uint16_t* begin(int width, int height) {
        const uint32_t slot = find();
        Port::write(slot + first_window, memory);
        Port::write(slot + third_window, control);
        Port::write(slot + command, answers_memory);
        say(enable, 0);
        say(columns, static_cast<uint16_t>(width)), say(rows, static_cast<uint16_t>(height)), say(bits_a_pixel, 16);
        say(virtual_columns, static_cast<uint16_t>(width));
        say(enable, 0x41);  // on, with linear memory
        return reinterpret_cast<volatile uint16_t*>(memory);
    }

private:
    static constexpr uint32_t configuration = 0x30000000, slots = 32, slot_bytes = 0x8000, identity = 0x11111234;
    static constexpr uint32_t command = 4, first_window = 0x10, third_window = 0x18, answers_memory = 2;
    static constexpr uint32_t memory = 0x40000000, control = 0x42000000;
    static constexpr uint32_t columns = 1, rows = 2, bits_a_pixel = 3, enable = 4, virtual_columns = 6;

    static uint32_t find() {
        for (uint32_t i = 0; i < slots; ++i)
            if (Port::read(configuration + i * slot_bytes) == identity) return configuration + i * slot_bytes;
        console::fail("There is no bochs-display on the PCI bus: start QEMU with '-device bochs-display,romfile='.");
    }
    /// The registers are 16 bits wide.
    static void say(uint32_t index, uint16_t value) { *reinterpret_cast<volatile uint16_t*>(control + 0x500 + 2 * index) = value; }
};

}  // namespace shade16
