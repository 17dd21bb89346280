// SPI 1 of an FE310, on lines 5 (clock) and 3 (data). It has no DMA, and no flag that says that the last bit is on the wire: every byte that
// was sent brings one back, and those are counted.
// Source: SiFive FE310-G000 Manual: 19 (SPI).
#pragma once

#include <mcu/fe310/chip.hpp>
#include <shade16/shade16.hpp>

namespace shade16::fe310 {

template <uint32_t Hz, class Port = Registers>
class Spi1 {
    static_assert(Hz > 0 && Hz <= cpu_hz / 2, "SPI runs at half the chip's clock at most (FE310-G000 manual, 19.4)");
    static constexpr uint32_t divisor = (cpu_hz / 2 + Hz - 1) / Hz - 1;
    static_assert(divisor < 4096, "SPI divides the chip's clock by 8192 at most (FE310-G000 manual, 19.4)");

public:
    using Format = Rgb565Swapped;
    static constexpr uint32_t hz = cpu_hz / (2 * (divisor + 1));
    static constexpr int clock_line = 5, data_line = 3;

    static void begin() {
        assign<clock_line, Port>(), assign<data_line, Port>();
        Port::write(base, divisor);
        Port::write(base + mode, 0);
        Port::write(base + select_mode, 3);  // the display's select is a line of its own
        Port::write(base + format, 8 << 16);  // eight bits on one wire, the highest first; what comes back is kept
    }
    void send(uint8_t byte) {
        if (on_their_way_ == fifo) take_one();
        if (!wait_for<Port>(base + to_send, no_more, 0)) console::fail("The display's bus takes no byte.");
        Port::write(base + to_send, byte);
        ++on_their_way_;
    }
    /// Returns when they are sent, but for the last eight bytes.
    void pixels(const Rgb565Swapped::Pixel* pixels, size_t count) {
        const auto* bytes = reinterpret_cast<const uint8_t*>(pixels);
        for (size_t i = 0; i < 2 * count; ++i) send(bytes[i]);
    }
    void wait() {
        while (on_their_way_ != 0) take_one();
    }
    static void delay_ms(uint32_t ms) { fe310::delay_ms<Port>(ms); }

private:
    static constexpr uint32_t base = 0x10024000, mode = 4, select_mode = 0x18, format = 0x40, to_send = 0x48, received = 0x4C;
    static constexpr uint32_t no_more = uint32_t{1} << 31, none = uint32_t{1} << 31;
    static constexpr int fifo = 8;

    void take_one() {
        // A read takes a byte out, so that each must be looked at.
        for (uint32_t tries = 1'000'000; tries != 0; --tries)
            if ((Port::read(base + received) & none) == 0) {
                --on_their_way_;
                return;
            }
        console::fail("The display's bus does not send: is its clock on?");
    }
    int on_their_way_ = 0;
};

}  // namespace shade16::fe310
