// Registers of the chip: memory that does what it is told. A driver takes them as a template parameter, so that a test on a
// computer can be the chip.
#pragma once

#include <stdint.h>

namespace shade16 {

struct Registers {
    static uint32_t read(uint32_t address) { return *reinterpret_cast<volatile uint32_t*>(address); }
    static void write(uint32_t address, uint32_t value) { *reinterpret_cast<volatile uint32_t*>(address) = value; }
    /// How the chip's own DMA calls a piece of memory.
    static uint32_t address_of(const void* memory) { return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(memory)); }
};

/// Sets bits of a register and leaves the others.
template <class Port>
void set_bits(uint32_t address, uint32_t bits) {
    Port::write(address, Port::read(address) | bits);
}

/// Waits until `bits` of a register are as `wanted`, at most `tries` reads; false when they never were.
template <class Port>
[[nodiscard]] bool wait_for(uint32_t address, uint32_t bits, uint32_t wanted, uint32_t tries = 1'000'000) {
    for (; tries != 0; --tries)
        if ((Port::read(address) & bits) == wanted) return true;
    return false;
}

}  // namespace shade16
