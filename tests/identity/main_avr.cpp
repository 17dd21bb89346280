// Prints the hashes of one group of kernels from an ATmega1284P: from reset to the end, with the text on its serial port.
// Its data sheet (Microchip, "Register Summary") has the addresses.
#include "tests/identity/kernels.hpp"

namespace {

volatile uint8_t& status = *reinterpret_cast<volatile uint8_t*>(0xC0);   // UCSR0A
volatile uint8_t& control = *reinterpret_cast<volatile uint8_t*>(0xC1);  // UCSR0B
volatile uint8_t& data = *reinterpret_cast<volatile uint8_t*>(0xC6);     // UDR0

constexpr uint8_t transmitter_is_ready = 1 << 5, transmit = 1 << 3;

}  // namespace

namespace shade16::console {

void print(const char* text) {
    for (; *text != 0; ++text) {
        while ((status & transmitter_is_ready) == 0) {
        }
        data = static_cast<uint8_t>(*text);
    }
}

// A processor that sleeps without interrupts is one that simavr stops.
void exit(int) {
    for (;;) asm volatile("cli\n\tsleep");
}

}  // namespace shade16::console

extern "C" {

// No interrupt is ever enabled, so the reset vector is the only one. avr-gcc's library has .init4, which fills the variables.
[[gnu::naked, gnu::used, gnu::section(".vectors")]] void shade16_reset() { asm("jmp shade16_stack"); }

[[gnu::naked, gnu::used, gnu::section(".init2")]] void shade16_stack() {
    asm("clr r1\n\t"
        "ldi r28, 0xFF\n\t"
        "out 0x3D, r28\n\t"  // SPL
        "ldi r28, 0x40\n\t"
        "out 0x3E, r28");  // SPH: the last byte of RAM is 0x40FF
}

[[gnu::naked, gnu::used, gnu::section(".init9")]] void shade16_start() { asm("jmp shade16_say_hashes"); }

[[gnu::used]] void shade16_say_hashes() {
    control = transmit;
    shade16::identity::SHADE16_KERNELS({.quick = SHADE16_INPUTS, .slow = SHADE16_INPUTS});
    shade16::console::exit(0);
}

}
