// RP2040: clocks, lines, the microsecond timer. 125 MHz from a crystal of 12 MHz, as on the Raspberry Pi Pico.
// Source: RP2040 Datasheet, Raspberry Pi Ltd: 2.14 (resets), 2.15 (clocks), 2.16 (crystal), 2.18 (PLL), 2.19 (lines), 4.6 (timer).
#pragma once

#include <mcu/registers.hpp>
#include <runtime/console.hpp>

namespace shade16::rp2040 {

inline constexpr uint32_t cpu_hz = 125'000'000;

namespace detail {
inline constexpr uint32_t resets = 0x4000C000, clocks = 0x40008000, crystal = 0x40024000, pll = 0x40028000, lines = 0x40014000, timer = 0x40054000, watchdog = 0x40058000,
                          output = 0xD0000000;
inline constexpr uint32_t clear_alias = 0x3000, set_alias = 0x2000;  // of every peripheral but the outputs: bits alone
}  // namespace detail

/// What a line does.
enum class Function : uint32_t { spi = 1, uart = 2, software = 5 };

/// Parts of the chip that rest in reset until they are wanted.
namespace part {
inline constexpr uint32_t dma = 1 << 2, io_bank = 1 << 5, pads = 1 << 8, pll = 1 << 12, spi0 = 1 << 16, timer = 1 << 21, uart0 = 1 << 22;
}
template <class Port = Registers>
void wake(uint32_t parts) {
    Port::write(detail::resets + detail::clear_alias, parts);
    if (!wait_for<Port>(detail::resets + 8, parts, parts)) console::fail("A part of the chip does not leave its reset.");
}

/// Runs from the crystal and the PLL, and lets the timer count microseconds.
template <class Port = Registers>
void begin_clocks() {
    using namespace detail;
    constexpr uint32_t ready = uint32_t{1} << 31;
    Port::write(crystal + 0x0C, 47);         // a millisecond to start
    Port::write(crystal, 0xFABAA0);          // on, 1 to 15 MHz
    if (!wait_for<Port>(crystal + 4, ready, ready)) console::fail("The crystal does not start.");
    Port::write(clocks + 0x30, 2);           // the reference is the crystal
    wake<Port>(part::pll);
    Port::write(pll, 1);
    Port::write(pll + 8, 125);               // 1500 MHz
    Port::write(pll + clear_alias + 4, 1 | 1 << 5);  // power to the PLL and its oscillator
    if (!wait_for<Port>(pll, ready, ready)) console::fail("The PLL does not lock.");
    Port::write(pll + 12, 6 << 16 | 2 << 12);        // divided by 6 and by 2
    Port::write(pll + clear_alias + 4, 1 << 3);      // power to the dividers
    Port::write(clocks + 0x3C, 0);
    Port::write(clocks + 0x3C, 1);           // the system is the PLL
    Port::write(clocks + 0x48, 1 << 11);     // peripherals take the system's clock
    Port::write(watchdog + 0x2C, 12 | 1 << 9);  // a tick a microsecond
    wake<Port>(part::io_bank | part::pads | part::timer);
}

template <class Port = Registers>
void delay_ms(uint32_t ms) {
    const uint32_t from = Port::read(detail::timer + 0x28);
    // The second bound is for a timer that stands still: no read takes less than eight cycles.
    for (uint64_t tries = static_cast<uint64_t>(ms) * (cpu_hz / 8000); tries != 0; --tries)
        if (Port::read(detail::timer + 0x28) - from >= ms * 1000) return;
}

template <class Port = Registers>
void assign(unsigned line, Function function) {
    Port::write(detail::lines + 8 * line + 4, static_cast<uint32_t>(function));
}

/// One line as an output.
template <unsigned Line, class Port = Registers>
struct Output {
    static_assert(Line <= 29, "this chip has the lines 0 to 29 (RP2040 datasheet, table 2)");
    static constexpr int number = Line;
    static void begin(bool high) {
        set(high);
        Port::write(detail::output + 0x24, mask);  // an output
        assign<Port>(Line, Function::software);
    }
    static void set(bool high) { Port::write(detail::output + (high ? 0x14 : 0x18), mask); }

private:
    static constexpr uint32_t mask = uint32_t{1} << Line;
};

}  // namespace shade16::rp2040
