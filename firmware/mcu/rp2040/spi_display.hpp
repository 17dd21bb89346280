// A display on SPI 0 of an RP2040: commands byte by byte, pixels by DMA while the engine draws the next band.
// Source: RP2040 Datasheet, Raspberry Pi Ltd: 2.5 (DMA), 4.4 (SPI).
#pragma once

#include <mcu/rp2040/chip.hpp>
#include <shade16/shade16.hpp>

namespace shade16::rp2040 {

/// Which line does what.
struct DisplayLines {
    unsigned clock = 18, data = 19, select = 17, command = 20, reset = 21, backlight = 22;
};

template <DisplayLines lines, uint32_t Hz, class Port = Registers>
class SpiDisplay {
    static_assert(lines.clock % 4 == 2 && lines.clock != 10 && lines.clock != 14 && lines.clock != 26, "this line cannot be the clock of SPI 0 (RP2040 datasheet, table 2: 2, 6, 18 or 22)");
    static_assert(lines.data % 4 == 3 && lines.data != 11 && lines.data != 15 && lines.data != 27, "this line cannot be the data of SPI 0 (RP2040 datasheet, table 2: 3, 7, 19 or 23)");
    static_assert(Hz > 0 && Hz <= cpu_hz / 2, "SPI runs at half the chip's clock at most, 62.5 MHz (RP2040 datasheet, 4.4.3.4)");
    static constexpr uint32_t divisor = ((cpu_hz + Hz - 1) / Hz + 1) & ~uint32_t{1};
    static_assert(divisor <= 254, "SPI divides the chip's clock by 254 at most (RP2040 datasheet, 4.4.3.4)");

public:
    using Format = Rgb565Swapped;
    static constexpr uint32_t bus_hz = cpu_hz / divisor;

    void reset() {
        wake<Port>(part::spi0 | part::dma);
        assign<Port>(lines.clock, Function::spi), assign<Port>(lines.data, Function::spi);
        Select::begin(true), Command::begin(true), Reset::begin(true), Backlight::begin(false);
        Port::write(spi + prescale, divisor);
        Port::write(spi + control_0, 7);  // eight bits, mode 0
        Port::write(spi + dma_control, 2);
        Port::write(spi + control_1, 2);  // enabled, master
        Select::set(false);
        Reset::set(false), delay_ms(1), Reset::set(true), delay_ms(120);
    }
    void command(uint8_t byte) {
        wait();
        Command::set(false), send(byte);
        wait();
        Command::set(true);
    }
    void data(const uint8_t* bytes, size_t count) {
        for (size_t i = 0; i < count; ++i) send(bytes[i]);
        wait();
    }
    /// Returns at once; the pixels are the bus's until `wait` returns.
    void pixels(const Rgb565Swapped::Pixel* pixels, size_t count) {
        Port::write(channel, static_cast<uint32_t>(reinterpret_cast<uintptr_t>(pixels)));
        Port::write(channel + 4, spi + data_register);
        Port::write(channel + 8, static_cast<uint32_t>(2 * count));
        Port::write(channel + 12, dma_on | dma_reads_on | spi_asks << 15);
        Backlight::set(true);  // there is something to see
    }
    /// Until the last bit is on the wire.
    void wait() {
        if (!wait_for<Port>(channel + 12, dma_busy, 0, most_tries)) console::fail("The DMA to the display never ends: does the bus take no bytes?");
        if (!wait_for<Port>(spi + status, busy, 0)) console::fail("The display's bus stays busy.");
        while ((Port::read(spi + status) & has_received) != 0) static_cast<void>(Port::read(spi + data_register));
    }
    void delay_ms(uint32_t ms) { rp2040::delay_ms<Port>(ms); }

private:
    using Select = Output<lines.select, Port>;
    using Command = Output<lines.command, Port>;
    using Reset = Output<lines.reset, Port>;
    using Backlight = Output<lines.backlight, Port>;
    static constexpr uint32_t spi = 0x4003C000, control_0 = 0, control_1 = 4, data_register = 8, status = 12, prescale = 16, dma_control = 0x24;
    static constexpr uint32_t may_send = 2, has_received = 4, busy = 16;
    static constexpr uint32_t channel = 0x50000000, dma_on = 1, dma_reads_on = 1 << 4, dma_busy = 1 << 24, spi_asks = 16;
    static constexpr uint32_t most_tries = 100'000'000;  // some seconds

    void send(uint8_t byte) {
        if (!wait_for<Port>(spi + status, may_send, may_send)) console::fail("The display's bus takes no byte.");
        Port::write(spi + data_register, byte);
    }
};

}  // namespace shade16::rp2040
