// An FE310 as far as a display needs one: clocks, lines, SPI 1, the machine timer. Strict: what is wired to nothing, lost or told too early is
// a complaint.
// Source: SiFive FE310-G000 Manual.
#pragma once

#include <map>

#include "tests/chips/chip.hpp"

namespace shade16::chips {

class Fe310 : public Complaints {
public:
    /// Lines by number, but for SPI's own.
    struct Wiring {
        int select, command, reset;
    };
    Fe310(displays::DcsModel& model, Wiring wiring) : wires_(model), wiring_(wiring) { registers_[pll] = on_reset; }

    uint32_t read(uint32_t address);
    void write(uint32_t address, uint32_t value);
    static uint32_t address_of(const void*) { return 0; }

    /// What does not work any more.
    bool crystal_is_dead = false, pll_is_dead = false, spi_is_dead = false, timer_is_dead = false;
    uint32_t cpu_hz() const;
    uint32_t spi_hz() const { return cpu_hz() / (2 * (at(spi) + 1)); }

private:
    static constexpr uint32_t ring = 0x10008000, crystal = 0x10008004, pll = 0x10008008, divisor = 0x1000800C, on_reset = 1 << 18;
    static constexpr uint32_t gpio = 0x10012000, flash_divisor = 0x10014000, spi = 0x10024000, timer = 0x0200BFF8;
    static constexpr size_t fifo = 8;
    static constexpr int ticks_to_lock = 4;  // 100 us

    uint32_t at(uint32_t address) const {
        const auto found = registers_.find(address);
        return found == registers_.end() ? 0 : found->second;
    }
    bool has(uint32_t offset, int line) const { return (at(gpio + offset) >> line & 1) != 0; }
    bool is_high(int line) const { return has(8, line) && has(0xC, line) && !has(0x38, line); }
    bool is_serial(int line) const { return has(0x38, line) && !has(0x3C, line); }
    void set_pll(uint32_t value);
    void wire_lines();
    void send(uint8_t byte);
    uint32_t take();
    void tick();

    std::map<uint32_t, uint32_t> registers_{};
    Wires wires_;
    Wiring wiring_;
    bool reset_was_high_ = true;
    std::deque<uint8_t> to_send_{};
    size_t came_back_ = 0;
    uint32_t ticks_ = 0;
    int unlocked_ = 0;  // ticks until the lock means something
};

}  // namespace shade16::chips
