// SiFive FE310-G000: clocks, lines, the real-time clock. 256 MHz from a crystal of 16 MHz, as on the HiFive1.
// Source: SiFive FE310-G000 Manual: 6 (clocks), 9 (machine timer), 17 (lines), 19 (SPI); its datasheet: which lines the package has.
#pragma once

#include <mcu/registers.hpp>
#include <runtime/console.hpp>

namespace shade16::fe310 {

inline constexpr uint32_t cpu_hz = 256'000'000, ticks_hz = 32'768;

namespace detail {
inline constexpr uint32_t clocks = 0x10008000, ring = clocks, crystal = clocks + 4, pll = clocks + 8, pll_divisor = clocks + 12;
inline constexpr uint32_t lines = 0x10012000, flash_divisor = 0x10014000, ticks = 0x0200BFF8;
}  // namespace detail

template <class Port = Registers>
void delay_ms(uint32_t ms) {
    const uint32_t wanted = (ms * ticks_hz + 999) / 1000 + 1, from = Port::read(detail::ticks);
    // The second bound is for a clock that stands still: no read takes less than two cycles.
    for (uint64_t tries = static_cast<uint64_t>(ms + 1) * (cpu_hz / 2000); tries != 0; --tries)
        if (Port::read(detail::ticks) - from >= wanted) return;
}

/// Runs from the crystal and the PLL: 16 MHz / 2 * 64 / 2. On the ring oscillator meanwhile, for a loader may have left the PLL on.
template <class Port = Registers>
void begin_clocks() {
    using namespace detail;
    constexpr uint32_t on = uint32_t{1} << 30, ready = uint32_t{1} << 31, selected = 1 << 16, of_crystal = 1 << 17, divided = 1 << 8;
    set_bits<Port>(ring, on);
    if (!wait_for<Port>(ring, ready, ready)) console::fail("The ring oscillator does not start.");
    Port::write(pll, Port::read(pll) & ~selected);
    Port::write(crystal, on);
    if (!wait_for<Port>(crystal, ready, ready)) console::fail("The crystal does not start.");
    Port::write(flash_divisor, 3);  // 32 MHz: the flash reads at 50 at most
    Port::write(pll_divisor, divided);
    Port::write(pll, 1 | 31 << 4 | 1 << 10 | of_crystal);
    delay_ms<Port>(1);  // the lock means nothing for the first 100 us
    if (!wait_for<Port>(pll, ready, ready)) console::fail("The PLL does not lock.");
    set_bits<Port>(pll, selected);
}

namespace detail {
inline constexpr uint32_t output_on = lines + 8, output = lines + 12, function_on = lines + 0x38, second_function = lines + 0x3C;
constexpr bool has_line(unsigned line) { return line <= 5 || (line >= 9 && line <= 13) || (line >= 16 && line <= 23); }
template <class Port>
void clear_bits(uint32_t address, uint32_t bits) {
    Port::write(address, Port::read(address) & ~bits);
}
}  // namespace detail

/// Gives a line to the first of the parts that can have it.
template <unsigned Line, class Port = Registers>
void assign() {
    static_assert(detail::has_line(Line), "the package has the lines 0 to 5, 9 to 13 and 16 to 23 (FE310-G000 datasheet, GPIO)");
    detail::clear_bits<Port>(detail::second_function, uint32_t{1} << Line);
    set_bits<Port>(detail::function_on, uint32_t{1} << Line);
}

/// One line as an output.
template <unsigned Line, class Port = Registers>
struct Output {
    static_assert(detail::has_line(Line), "the package has the lines 0 to 5, 9 to 13 and 16 to 23 (FE310-G000 datasheet, GPIO)");
    static constexpr int number = Line;
    static void begin(bool high) {
        detail::clear_bits<Port>(detail::function_on, mask);
        set(high);
        set_bits<Port>(detail::output_on, mask);
    }
    static void set(bool high) {
        if (high) set_bits<Port>(detail::output, mask);
        else detail::clear_bits<Port>(detail::output, mask);
    }

private:
    static constexpr uint32_t mask = uint32_t{1} << Line;
};

}  // namespace shade16::fe310
