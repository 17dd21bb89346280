// SPI 0 of an RP2040: bytes one by one, pixels by DMA while the engine draws the next band.
// Source: RP2040 Datasheet, Raspberry Pi Ltd: 2.5 (DMA), 4.4 (SPI).
#pragma once

#include <mcu/rp2040/chip.hpp>
#include <shade16/shade16.hpp>

namespace shade16::rp2040 {

template <unsigned Clock, unsigned Data, uint32_t Hz, class Port = Registers>
class Spi0 {
    static_assert(Clock == 2 || Clock == 6 || Clock == 18 || Clock == 22, "this line cannot be the clock of SPI 0 (RP2040 datasheet, table 2: 2, 6, 18 or 22)");
    static_assert(Data == 3 || Data == 7 || Data == 19 || Data == 23, "this line cannot be the data of SPI 0 (RP2040 datasheet, table 2: 3, 7, 19 or 23)");
    static_assert(Hz > 0 && Hz <= cpu_hz / 2, "SPI runs at half the chip's clock at most, 62.5 MHz (RP2040 datasheet, 4.4.3.4)");
    static constexpr uint32_t divisor = ((cpu_hz + Hz - 1) / Hz + 1) & ~uint32_t{1};
    static_assert(divisor <= 254, "SPI divides the chip's clock by 254 at most (RP2040 datasheet, 4.4.3.4)");

public:
    using Format = Rgb565Swapped;
    static constexpr uint32_t hz = cpu_hz / divisor;
    static constexpr int clock_line = Clock, data_line = Data;

    static void begin() {
        wake<Port>(part::spi0 | part::dma);
        assign<Port>(Clock, Function::spi), assign<Port>(Data, Function::spi);
        Port::write(spi + prescale, divisor);
        Port::write(spi + control_0, 7);  // eight bits, mode 0
        Port::write(spi + dma_control, 2);
        Port::write(spi + control_1, 2);  // enabled, master
    }
    void send(uint8_t byte) {
        if (!wait_for<Port>(spi + status, may_send, may_send)) console::fail("The display's bus takes no byte.");
        Port::write(spi + data_register, byte);
    }
    /// Returns at once.
    void pixels(const Rgb565Swapped::Pixel* pixels, size_t count) {
        Port::write(channel, Port::address_of(pixels));
        Port::write(channel + 4, spi + data_register);
        Port::write(channel + 8, static_cast<uint32_t>(2 * count));
        Port::write(channel + 12, dma_on | dma_reads_on | spi_asks << 15);
    }
    void wait() {
        if (!wait_for<Port>(channel + 12, dma_busy, 0, most_tries)) console::fail("The DMA to the display never ends: does the bus take no bytes?");
        if (!wait_for<Port>(spi + status, busy, 0)) console::fail("The display's bus stays busy.");
        for (int held = fifo; held != 0 && (Port::read(spi + status) & has_received) != 0; --held) static_cast<void>(Port::read(spi + data_register));
    }
    static void delay_ms(uint32_t ms) { rp2040::delay_ms<Port>(ms); }

private:
    static constexpr uint32_t spi = 0x4003C000, control_0 = 0, control_1 = 4, data_register = 8, status = 12, prescale = 16, dma_control = 0x24;
    static constexpr uint32_t may_send = 2, has_received = 4, busy = 16;
    static constexpr int fifo = 8;
    static constexpr uint32_t channel = 0x50000000, dma_on = 1, dma_reads_on = 1 << 4, dma_busy = 1 << 24, spi_asks = 16;
    static constexpr uint32_t most_tries = 100'000'000;  // some seconds
};

}  // namespace shade16::rp2040
