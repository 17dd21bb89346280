// An STM32F4 as far as a display needs one: clocks, lines, SPI 1, stream 3 of DMA 2, SysTick. Strict: what is used before its clock is on,
// wired to nothing or told while it works is a complaint.
// Source: RM0090 Reference manual, STMicroelectronics.
#pragma once

#include <map>

#include "tests/chips/chip.hpp"

namespace shade16::chips {

class Stm32f4 : public Complaints {
public:
    /// Lines by number: (port - 'A') * 16 + bit.
    struct Wiring {
        int clock, data, select, command, reset;
    };
    Stm32f4(displays::DcsModel& model, Wiring wiring) : wires_(model), wiring_(wiring) {}

    uint32_t read(uint32_t address);
    void write(uint32_t address, uint32_t value);
    uint32_t address_of(const void* memory);

    /// What does not work any more.
    bool crystal_is_dead = false, dma_is_dead = false, spi_is_dead = false;
    /// What the clocks have come to: the processor's, and its buses'.
    uint32_t cpu_hz() const;
    uint32_t bus_hz(unsigned shift) const;
    uint32_t spi_hz() const { return bus_hz(13) >> ((at(spi) >> 3 & 7) + 1); }

private:
    static constexpr uint32_t rcc = 0x40023800, flash = 0x40023C00, gpio = 0x40020000, spi = 0x40013000, dma = 0x40026400, ticks = 0xE000E010;
    static constexpr uint32_t stream = dma + 0x58;

    uint32_t at(uint32_t address) const {
        const auto found = registers_.find(address);
        return found == registers_.end() ? 0 : found->second;
    }
    uint32_t field(int line, uint32_t offset, unsigned width) const;
    bool is_high(int line) const { return field(line, 0, 2) == 1 && field(line, 0x14, 1) != 0; }
    bool is_serial(int line) const { return field(line, 0, 2) == 2 && field(line, 0x20, 4) == 5; }
    void expect_clock(uint32_t address);
    void set_lines(uint32_t port, uint32_t value);
    void wire_lines();
    void send(uint8_t byte);
    void begin_stream(uint32_t value);
    void tick();

    std::map<uint32_t, uint32_t> registers_{};
    Wires wires_;
    Wiring wiring_;
    bool reset_was_high_ = true, holds_ = false, streams_ = false, stream_ended_ = false;
    uint8_t held_ = 0;
    std::vector<const uint8_t*> memory_{};
    const uint8_t* next_ = nullptr;
};

}  // namespace shade16::chips
