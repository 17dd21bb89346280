// UART 0 of an FE310, 115200 baud on line 17.
// Source: SiFive FE310-G000 Manual: 18 (UART).
#pragma once

#include <mcu/fe310/chip.hpp>

namespace shade16::fe310 {

template <class Port = Registers>
struct Uart0 {
    static void begin() {
        assign<17, Port>();
        Port::write(base + 0x18, cpu_hz / 115'200 - 1);
        Port::write(base + 8, 1);
    }
    /// A byte that cannot be sent is dropped: nobody could be told.
    static void send(uint8_t byte) {
        if (wait_for<Port>(base, full, 0)) Port::write(base, byte);
    }
    static int heard() { return -1; }  // it only speaks
    /// Until fewer than one byte waits. The last one may be on the wire yet.
    static void wait() {
        Port::write(base + 8, 1 | 1 << 16);
        static_cast<void>(wait_for<Port>(base + 0x14, 1, 1));
    }

private:
    static constexpr uint32_t base = 0x10013000, full = uint32_t{1} << 31;
};

}  // namespace shade16::fe310
