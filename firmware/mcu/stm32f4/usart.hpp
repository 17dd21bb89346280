// USART 2 of an STM32F4, 115200 baud on line A2.
// Source: RM0090 Reference manual, STMicroelectronics: 30.6 (USART).
#pragma once

#include <mcu/stm32f4/chip.hpp>

namespace shade16::stm32f4 {

template <class Port = Registers>
struct Usart2 {
    static void begin() {
        set_bits<Port>(detail::apb1_gates, 1 << 17);
        assign<Pin{'A', 2}, Port>(7);
        Port::write(base + 8, (slow_bus_hz + baud / 2) / baud);
        Port::write(base + 0xC, 1 << 13 | 1 << 3);  // on, sending
    }
    /// A byte that cannot be sent is dropped: nobody could be told.
    static void send(uint8_t byte) {
        if (wait_for<Port>(base, may_send, may_send)) Port::write(base + 4, byte);
    }
    static int heard() { return -1; }  // it only speaks
    static void wait() { static_cast<void>(wait_for<Port>(base, all_sent, all_sent)); }

private:
    static constexpr uint32_t base = 0x40004400, baud = 115'200, may_send = 1 << 7, all_sent = 1 << 6;
};

}  // namespace shade16::stm32f4
