// STM32F405 and STM32F407: clocks, lines, milliseconds. 168 MHz from a crystal of 8 MHz, as on the Discovery board and most others.
// Source: RM0090 Reference manual, STMicroelectronics: 3.9 (flash), 5.4 (power), 7.3 (clocks), 8.4 (lines); Cortex-M4 Devices Generic User
// Guide, Arm: 4.4 (SysTick).
#pragma once

#include <mcu/registers.hpp>
#include <runtime/console.hpp>

namespace shade16::stm32f4 {

inline constexpr uint32_t cpu_hz = 168'000'000, fast_bus_hz = cpu_hz / 2, slow_bus_hz = cpu_hz / 4;

namespace detail {
inline constexpr uint32_t power = 0x40007000, flash = 0x40023C00, lines = 0x40020000, ticks = 0xE000E010;
inline constexpr uint32_t clocks = 0x40023800, crystal_and_pll = clocks, pll = clocks + 4, buses = clocks + 8;
inline constexpr uint32_t ahb1_gates = clocks + 0x30, apb1_gates = clocks + 0x40, apb2_gates = clocks + 0x44;
}  // namespace detail

/// Runs from the crystal and the PLL: 8 MHz / 8 * 336 / 2.
template <class Port = Registers>
void begin_clocks() {
    using namespace detail;
    constexpr uint32_t crystal_on = 1 << 16, crystal_ready = 1 << 17, pll_on = 1 << 24, pll_ready = 1 << 25;
    set_bits<Port>(apb1_gates, 1 << 28);
    set_bits<Port>(power, 1 << 14);  // the voltage that 168 MHz need
    set_bits<Port>(crystal_and_pll, crystal_on);
    if (!wait_for<Port>(crystal_and_pll, crystal_ready, crystal_ready)) console::fail("The crystal does not start.");
    Port::write(pll, 8 | 336 << 6 | 1 << 22 | 7 << 24);
    set_bits<Port>(crystal_and_pll, pll_on);
    if (!wait_for<Port>(crystal_and_pll, pll_ready, pll_ready)) console::fail("The PLL does not lock.");
    Port::write(flash, 5 | 1 << 8 | 1 << 9 | 1 << 10);  // five wait states, prefetch and both caches
    Port::write(buses, 5 << 10 | 4 << 13);               // a quarter and a half of the processor's clock
    Port::write(buses, 5 << 10 | 4 << 13 | 2);           // which is the PLL
    if (!wait_for<Port>(buses, 3 << 2, 2 << 2)) console::fail("The processor does not take the PLL's clock.");
}

template <class Port = Registers>
void delay_ms(uint32_t ms) {
    constexpr uint32_t has_counted = 1 << 16, on = 1 | 1 << 2, tries_a_ms = cpu_hz / 1000;
    Port::write(detail::ticks + 4, cpu_hz / 1000 - 1);
    Port::write(detail::ticks + 8, 0);
    Port::write(detail::ticks, on);
    for (; ms != 0; --ms)
        if (!wait_for<Port>(detail::ticks, has_counted, has_counted, tries_a_ms)) console::fail("SysTick does not count.");
}

/// A line of the chip: Pin{'A', 5}.
struct Pin {
    char port = 'A';
    unsigned bit = 0;
    friend constexpr bool operator==(const Pin&, const Pin&) = default;
    constexpr bool exists() const { return port >= 'A' && port <= 'I' && bit <= 15; }
    constexpr int number() const { return (port - 'A') * 16 + static_cast<int>(bit); }
};

namespace detail {
template <Pin pin, class Port>
struct Line {
    static_assert(pin.exists(), "this chip has the lines A0 to I15 (RM0090, 8.1)");
    static constexpr uint32_t base = lines + static_cast<uint32_t>(pin.port - 'A') * 0x400;

    static void switch_on() { set_bits<Port>(ahb1_gates, uint32_t{1} << (pin.port - 'A')); }
    /// A field of `width` bits a line, in one or two registers.
    static void set_field(uint32_t offset, unsigned width, uint32_t value) {
        const unsigned at = pin.bit * width;
        const uint32_t address = base + offset + at / 32 * 4;
        const uint32_t mask = ((uint32_t{1} << width) - 1) << at % 32;
        Port::write(address, (Port::read(address) & ~mask) | value << at % 32);
    }
};
inline constexpr uint32_t mode = 0, speed = 8, set_and_reset = 0x18, alternate = 0x20;
}  // namespace detail

/// One line as an output.
template <Pin pin, class Port = Registers>
struct Output {
    static constexpr int number = pin.number();
    static void begin(bool high) {
        Line::switch_on();
        set(high);
        Line::set_field(detail::mode, 2, 1);
    }
    static void set(bool high) { Port::write(Line::base + detail::set_and_reset, uint32_t{1} << (pin.bit + (high ? 0 : 16))); }

private:
    using Line = detail::Line<pin, Port>;
};

/// Gives a line to a part of the chip, at full speed.
template <Pin pin, class Port = Registers>
void assign(uint32_t function) {
    using Line = detail::Line<pin, Port>;
    Line::switch_on();
    Line::set_field(detail::alternate, 4, function);
    Line::set_field(detail::speed, 2, 3);
    Line::set_field(detail::mode, 2, 2);
}

}  // namespace shade16::stm32f4
