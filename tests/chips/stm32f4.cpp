#include "tests/chips/stm32f4.hpp"

namespace shade16::chips {

uint32_t Stm32f4::field(int line, uint32_t offset, unsigned width) const {
    const auto bit = static_cast<unsigned>(line % 16) * width;
    const uint32_t address = gpio + static_cast<uint32_t>(line / 16) * 0x400 + offset + bit / 32 * 4;
    return at(address) >> bit % 32 & ((uint32_t{1} << width) - 1);
}

uint32_t Stm32f4::cpu_hz() const {
    const uint32_t pll = at(rcc + 4);
    if ((at(rcc + 8) & 3) != 2) return 16'000'000;
    return 8'000'000 / (pll & 63) * (pll >> 6 & 511) / (2 * ((pll >> 16 & 3) + 1));
}

uint32_t Stm32f4::bus_hz(unsigned shift) const {
    const uint32_t code = at(rcc + 8) >> shift & 7;
    return code < 4 ? cpu_hz() : cpu_hz() >> (code - 3);
}

void Stm32f4::expect_clock(uint32_t address) {
    const bool on = address >= spi && address < spi + 0x400     ? (at(rcc + 0x44) >> 12 & 1) != 0
                    : address >= dma && address < dma + 0x400   ? (at(rcc + 0x30) >> 22 & 1) != 0
                    : address >= gpio && address < gpio + 0x2400 ? (at(rcc + 0x30) >> ((address - gpio) / 0x400) & 1) != 0
                                                                 : true;
    expect(on, "a part of the chip is used before its clock is on");
}

uint32_t Stm32f4::read(uint32_t address) {
    tick();
    expect_clock(address);
    const uint32_t value = at(address);
    if (address == rcc) return crystal_is_dead ? value & ~(3u << 16) : value | (value & 1 << 16) << 1 | (value & 1 << 24) << 1;
    if (address == rcc + 8) return value | (value & 3) << 2;
    if (address == spi + 8) return (holds_ || spi_is_dead ? 0u : 2u) | (holds_ || wires_.busy() ? 0x80u : 0u);
    if (address == stream) return streams_ || dma_is_dead ? value | 1 : value & ~1u;
    if (address == ticks && (value & 5) == 5) {
        wires_.delay_ms(at(ticks + 4) + 1 == cpu_hz() / 1000 ? 1 : 0);
        return value | 1 << 16;
    }
    return value;
}

void Stm32f4::write(uint32_t address, uint32_t value) {
    tick();
    expect_clock(address);
    registers_[address] = value;
    if (address == rcc + 8 && (value & 3) == 2) {
        expect((read(rcc) >> 25 & 1) != 0, "the processor takes the PLL's clock before it has locked");
        expect((at(flash) & 7) >= 5, "the flash has too few wait states for the processor's clock");
    }
    if (address >= gpio && address < gpio + 0x2400) {
        if ((address - gpio) % 0x400 == 0x18) set_lines(address - 0x18, value);
        wire_lines();
    }
    if (address == spi + 0xC) send(static_cast<uint8_t>(value));
    if (address == dma + 8) stream_ended_ = stream_ended_ && (value & 1 << 27) == 0;
    if (address == stream && (value & 1) != 0) begin_stream(value);
}

uint32_t Stm32f4::address_of(const void* memory) {
    memory_.push_back(static_cast<const uint8_t*>(memory));
    return 0x20000000 + static_cast<uint32_t>(memory_.size() - 1);
}

void Stm32f4::set_lines(uint32_t port, uint32_t value) {
    uint32_t& out = registers_[port + 0x14];
    out = (out & ~(value >> 16)) | (value & 0xFFFF);
}

void Stm32f4::wire_lines() {
    wires_.selected = field(wiring_.select, 0, 2) == 1 && !is_high(wiring_.select);
    wires_.data = is_high(wiring_.command);
    const bool high = field(wiring_.reset, 0, 2) != 1 || is_high(wiring_.reset);
    if (high != reset_was_high_) wires_.reset(high);
    reset_was_high_ = high;
}

void Stm32f4::send(uint8_t byte) {
    expect(!holds_, "a byte is written over one that waits to be sent");
    expect((at(spi) & (1 << 2 | 1 << 6)) == (1 << 2 | 1 << 6) && (at(spi) & 3 << 8) == 3 << 8, "SPI is not on, no master or not selected");
    expect((at(spi) & (1 << 11 | 1 << 7 | 3)) == 0, "SPI does not send eight bits, the highest first, in mode 0");
    expect(is_serial(wiring_.clock) && is_serial(wiring_.data), "SPI has no wires: its lines are not given to it");
    expect(wires_.selected, "a byte is sent and the display is not selected");
    holds_ = true, held_ = byte;
}

void Stm32f4::begin_stream(uint32_t value) {
    expect(!streams_, "the stream is begun while it works");
    expect(!stream_ended_, "the stream is begun with its flags still set");
    expect((value >> 6 & 3) == 1 && (value >> 25 & 7) == 3 && (value & 1 << 10) != 0 && (value >> 11 & 15) == 0,
           "the stream is not from moving memory to SPI 1, byte by byte");
    expect((at(spi + 4) & 2) != 0 && at(stream + 8) == spi + 0xC, "the stream does not feed SPI 1");
    expect(at(stream + 4) - 1 < 65535, "the stream is to send more than 65535 bytes, or none");
    const uint32_t number = at(stream + 0xC) - 0x20000000;
    expect(number < memory_.size(), "the stream is from no memory of the program");
    if (number < memory_.size()) next_ = memory_[number], streams_ = true;
}

void Stm32f4::tick() {
    wires_.tick();
    if (streams_ && !holds_ && !dma_is_dead) {
        uint32_t& left = registers_[stream + 4];
        send(*next_++);
        if (--left == 0) streams_ = false, stream_ended_ = true, registers_[stream] &= ~1u;
    }
    if (holds_ && !wires_.busy() && !spi_is_dead) wires_.begin(held_), holds_ = false;
}

}  // namespace shade16::chips
