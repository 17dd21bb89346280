#include "tests/chips/fe310.hpp"

namespace shade16::chips {

uint32_t Fe310::cpu_hz() const {
    const uint32_t value = at(pll);
    if ((value & 1 << 16) == 0) return 13'800'000;
    const uint32_t of_crystal = (value & 1 << 17) != 0 ? 16'000'000 : 0;
    return (value & 1 << 18) != 0 ? of_crystal : of_crystal / ((value & 7) + 1) * (2 * ((value >> 4 & 63) + 1)) >> (value >> 10 & 3);
}

uint32_t Fe310::read(uint32_t address) {
    tick();
    const uint32_t value = at(address), on = value & uint32_t{1} << 30;
    if (address == ring) return value | on << 1;
    if (address == crystal) return crystal_is_dead ? value : value | on << 1;
    if (address == pll) return pll_is_dead ? value : value | uint32_t{1} << 31;
    if (address == spi + 0x48) return to_send_.size() == fifo ? uint32_t{1} << 31 : 0;
    if (address == spi + 0x4C) return take();
    if (address != timer || timer_is_dead) return value;
    if (unlocked_ > 0) --unlocked_;
    const uint64_t before_ms = ticks_ * uint64_t{1000} / 32768;
    ++ticks_;
    wires_.delay_ms(static_cast<uint32_t>(ticks_ * uint64_t{1000} / 32768 - before_ms));
    return ticks_;
}

void Fe310::write(uint32_t address, uint32_t value) {
    tick();
    if (address == pll) set_pll(value);
    registers_[address] = value;
    if (address >= gpio && address < gpio + 0x1000) wire_lines();
    if (address == spi + 0x48) send(static_cast<uint8_t>(value));
}

void Fe310::set_pll(uint32_t value) {
    constexpr uint32_t selected = 1 << 16;
    const bool changes = ((value ^ at(pll)) & ~selected & 0x7FFFFFFF) != 0;
    expect(!changes || (at(pll) & selected) == 0, "the PLL is changed while the processor runs from it");
    if (changes) unlocked_ = ticks_to_lock;
    if ((value & selected) == 0 || (at(pll) & selected) != 0) return;
    expect(unlocked_ == 0, "the PLL is selected before it can have locked");
    expect(at(divisor) == 1 << 8, "the PLL's clock is divided once more");
    expect((at(crystal) >> 30 & 1) != 0 && (value & 1 << 17) != 0, "the PLL has no crystal");
    registers_[pll] = value;
    expect(cpu_hz() / (2 * (at(flash_divisor) + 1)) <= 50'000'000, "the flash is read faster than it can be");
}

void Fe310::wire_lines() {
    expect(!has(8, wiring_.select) || !has(0x38, wiring_.select), "a line is an output and another part's as well");
    wires_.selected = has(8, wiring_.select) && !is_high(wiring_.select);
    wires_.data = is_high(wiring_.command);
    const bool high = !has(8, wiring_.reset) || is_high(wiring_.reset);
    if (high != reset_was_high_) wires_.reset(high);
    reset_was_high_ = high;
}

void Fe310::send(uint8_t byte) {
    expect(to_send_.size() < fifo, "a byte is sent and there is no place for it");
    expect(is_serial(5) && is_serial(3), "SPI has no wires: its lines are not given to it");
    expect(at(spi + 0x40) == 8 << 16 && at(spi + 4) == 0, "SPI does not send eight bits, the highest first, in mode 0, and keep what comes back");
    expect(at(spi + 0x18) == 3, "SPI moves a select line of its own");
    expect(wires_.selected, "a byte is sent and the display is not selected");
    to_send_.push_back(byte);
}

uint32_t Fe310::take() {
    if (came_back_ == 0) return uint32_t{1} << 31;
    --came_back_;
    return 0xFF;
}

void Fe310::tick() {
    if (wires_.tick()) {
        expect(came_back_ < fifo, "a byte came back and there was no place for it");
        if (came_back_ < fifo) ++came_back_;
    }
    if (to_send_.empty() || wires_.busy() || spi_is_dead) return;
    wires_.begin(to_send_.front());
    to_send_.pop_front();
}

}  // namespace shade16::chips
