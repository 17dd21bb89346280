// A display on a serial bus with a data/command line: what all chips have in common. The chip brings its interface and its lines.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace shade16 {

namespace detail {
template <int... lines>
constexpr bool all_differ() {
    constexpr int all[] = {lines...};
    constexpr size_t count = sizeof...(lines);
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < i; ++k)
            if (all[i] == all[k]) return false;
    return true;
}
}  // namespace detail

/// `Spi` has Format, hz, clock_line and data_line, begin(), send(byte), pixels(pixels, count), wait() until the last bit is on the wire and
/// delay_ms(ms); a line has number, begin(high) and set(high). The display is selected from the first reset on.
template <class Spi, class Select, class Command, class Reset, class Backlight>
class FourWire {
    static_assert(detail::all_differ<Spi::clock_line, Spi::data_line, Select::number, Command::number, Reset::number, Backlight::number>(),
                  "two of the display's wires are on one line of the chip");

public:
    using Format = typename Spi::Format;
    static constexpr uint32_t bus_hz = Spi::hz;

    void reset() {
        Spi::begin();
        Select::begin(true), Command::begin(true), Reset::begin(true), Backlight::begin(false);
        Select::set(false);
        Reset::set(false), Spi::delay_ms(1), Reset::set(true), Spi::delay_ms(120);
    }
    void command(uint8_t byte) {
        wait();
        Command::set(false), spi_.send(byte);
        wait();
        Command::set(true);
    }
    void data(const uint8_t* bytes, size_t count) {
        for (size_t i = 0; i < count; ++i) spi_.send(bytes[i]);
        wait();
    }
    /// May return before the pixels are sent: they are the bus's until `wait` returns.
    void pixels(const typename Format::Pixel* pixels, size_t count) {
        spi_.pixels(pixels, count);
        Backlight::set(true);  // there is something to see
    }
    void wait() { spi_.wait(); }
    void delay_ms(uint32_t ms) { Spi::delay_ms(ms); }

private:
    Spi spi_{};
};

}  // namespace shade16
