// UART 0 of an RP2040, 115200 baud: it speaks on line 0 and hears on line 1.
// Source: RP2040 Datasheet, Raspberry Pi Ltd: 4.2 (UART).
#pragma once

#include <mcu/rp2040/chip.hpp>

namespace shade16::rp2040 {

template <class Port = Registers>
struct Uart0 {
    static void begin() {
        wake<Port>(part::io_bank | part::pads | part::uart0);  // also where the clocks failed
        assign<Port>(0, Function::uart), assign<Port>(1, Function::uart);
        Port::write(base + 0x24, 67), Port::write(base + 0x28, 52);  // 125 MHz / 16 / 67.8
        Port::write(base + 0x2C, 0x70), Port::write(base + 0x30, 0x301);
    }
    /// A byte that cannot be sent is dropped: nobody could be told.
    static void send(uint8_t byte) {
        if (wait_for<Port>(flags, full, 0)) Port::write(base, byte);
    }
    static int heard() { return (Port::read(flags) & empty) != 0 ? -1 : static_cast<int>(Port::read(base) & 0xFF); }
    static void wait() { static_cast<void>(wait_for<Port>(flags, busy, 0)); }

private:
    static constexpr uint32_t base = 0x40034000, flags = base + 0x18, full = 1 << 5, empty = 1 << 4, busy = 1 << 3;
};

}  // namespace shade16::rp2040
