// SPI 1 of an STM32F4: bytes one by one, pixels by DMA while the engine draws the next band.
// Source: RM0090 Reference manual, STMicroelectronics: 10.5 (DMA), 28.5 (SPI); DS8626 datasheet: table 9 (which lines).
#pragma once

#include <mcu/stm32f4/chip.hpp>
#include <shade16/shade16.hpp>

namespace shade16::stm32f4 {

namespace detail {
/// By how many powers of two SPI divides its bus's clock, for `hz` at most.
constexpr int spi_divisor_log2(uint32_t hz) {
    int log2 = 1;
    while (log2 < 9 && fast_bus_hz >> log2 > hz) ++log2;
    return log2;
}
}  // namespace detail

template <Pin clock, Pin data, uint32_t Hz, class Port = Registers>
class Spi1 {
    static_assert(clock == Pin{'A', 5} || clock == Pin{'B', 3}, "this line cannot be the clock of SPI 1 (STM32F405 datasheet, table 9: A5 or B3)");
    static_assert(data == Pin{'A', 7} || data == Pin{'B', 5}, "this line cannot be the data of SPI 1 (STM32F405 datasheet, table 9: A7 or B5)");
    static_assert(Hz <= fast_bus_hz / 2, "SPI runs at half its clock of 84 MHz at most (RM0090, 28.5.1)");
    static_assert(Hz >= fast_bus_hz / 256, "SPI divides its clock of 84 MHz by 256 at most (RM0090, 28.5.1)");

public:
    using Format = Rgb565Swapped;
    static constexpr uint32_t hz = fast_bus_hz >> detail::spi_divisor_log2(Hz);
    static constexpr int clock_line = clock.number(), data_line = data.number();

    static void begin() {
        set_bits<Port>(detail::apb2_gates, 1 << 12);
        set_bits<Port>(detail::ahb1_gates, 1 << 22);  // DMA 2
        assign<clock, Port>(5), assign<data, Port>(5);
        constexpr uint32_t master = 1 << 2, on = 1 << 6, selected = 1 << 8 | 1 << 9, divisor = static_cast<uint32_t>(detail::spi_divisor_log2(Hz) - 1) << 3;
        Port::write(spi + control_1, master | divisor | selected);  // eight bits, mode 0
        Port::write(spi + control_2, 1 << 1);                       // DMA feeds it
        Port::write(spi + control_1, master | divisor | selected | on);
    }
    void send(uint8_t byte) {
        if (!wait_for<Port>(spi + status, may_send, may_send)) console::fail("The display's bus takes no byte: is its clock on?");
        Port::write(spi + data_register, byte);
    }
    /// Returns at once.
    void pixels(const Rgb565Swapped::Pixel* pixels, size_t count) {
        rest_ = reinterpret_cast<const uint8_t*>(pixels);
        rest_bytes_ = 2 * count;
        send_most();
    }
    void wait() {
        for (;;) {
            if (!wait_for<Port>(stream, dma_on, 0, most_tries)) console::fail("The DMA to the display never ends: does the bus take no bytes?");
            if (rest_bytes_ == 0) break;
            send_most();
        }
        if (!wait_for<Port>(spi + status, may_send, may_send)) console::fail("The display's bus takes no byte: is its clock on?");
        if (!wait_for<Port>(spi + status, busy, 0)) console::fail("The display's bus stays busy.");
    }
    static void delay_ms(uint32_t ms) { stm32f4::delay_ms<Port>(ms); }

private:
    static constexpr uint32_t spi = 0x40013000, control_1 = 0, control_2 = 4, status = 8, data_register = 0xC;
    static constexpr uint32_t may_send = 1 << 1, busy = 1 << 7;
    // Stream 3 of DMA 2; its channel 3 is what SPI 1 asks for bytes by.
    static constexpr uint32_t dma = 0x40026400, stream = dma + 0x10 + 3 * 0x18, clear_flags = dma + 8;
    static constexpr uint32_t flags_of_stream = 0x3D << 22, dma_on = 1, to_peripheral = 1 << 6, memory_moves = 1 << 10, channel = 3 << 25;
    static constexpr uint32_t most_tries = 100'000'000;  // some seconds
    static constexpr size_t most_bytes = 65534;          // the stream counts with 16 bits

    void send_most() {
        const size_t bytes = rest_bytes_ < most_bytes ? rest_bytes_ : most_bytes;
        Port::write(clear_flags, flags_of_stream);
        Port::write(stream + 8, spi + data_register);
        Port::write(stream + 0xC, Port::address_of(rest_));
        Port::write(stream + 4, static_cast<uint32_t>(bytes));
        Port::write(stream, channel | memory_moves | to_peripheral | dma_on);
        rest_ += bytes, rest_bytes_ -= bytes;
    }
    const uint8_t* rest_ = nullptr;  // what the stream has not been given yet
    size_t rest_bytes_ = 0;
};

}  // namespace shade16::stm32f4
