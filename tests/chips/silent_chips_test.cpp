// Hardware that does not answer: every wait of a driver ends, in a sentence. The STM32F4 and the FE310 have models of their own.
#include <gtest/gtest.h>

#include <mcu/lm3s.hpp>
#include <mcu/rp2040/spi.hpp>

#include "tests/chips/shown.hpp"

namespace shade16::chips {
namespace {

/// Registers that all read 0 but for these.
template <uint32_t... AddressThenValue>
struct Stuck {
    static uint32_t read(uint32_t address) {
        constexpr uint32_t said[] = {AddressThenValue..., 0, 0};
        for (size_t i = 0; i < sizeof...(AddressThenValue); i += 2)
            if (said[i] == address) return said[i + 1];
        return 0;
    }
    static void write(uint32_t, uint32_t) {}
    static uint32_t address_of(const void*) { return 0; }
};

TEST(Lm3s, SaysWhatDoesNotAnswer) {
    constexpr uint32_t status = 0x4000800C, command = 0x40020004, may_send = 2, busy = 1, error = 2;
    EXPECT_EQ(sentence_of([] { lm3s::Ssi0<50'000'000, 1'000'000, Stuck<>>::send(1); }), "The serial interface takes no byte: is its clock on?");
    EXPECT_EQ(sentence_of([] { lm3s::Ssi0<50'000'000, 1'000'000, Stuck<status, may_send>>::send(1); }), "The serial interface does not send: is it enabled?");
    EXPECT_EQ(sentence_of([] { lm3s::I2c<50'000'000, Stuck<command, busy>>::send(0x3D, 0, 1); }), "The I2C bus stays busy: is a line held low?");
    EXPECT_EQ(sentence_of([] { lm3s::I2c<50'000'000, Stuck<command, error>>::send(0x3D, 0, 1); }),
              "The display does not answer on the I2C bus: check its address and its wires.");
    EXPECT_EQ(sentence_of([] { lm3s::I2c<50'000'000, Stuck<>>::send(0x3D, 0, 1); }), "");
}

constexpr uint32_t resets = 0x4000C008, crystal = 0x40024004, pll = 0x40028000, ready = 1u << 31, awake = ~0u;
constexpr uint32_t spi_status = 0x4003C00C, dma = 0x5000000C, dma_busy = 1u << 24, may_send = 2, spi_busy = 16, received = 4;
template <class Port>
using Spi = rp2040::Spi0<18, 19, 31'250'000, Port>;

TEST(Rp2040, SaysWhatDoesNotStart) {
    EXPECT_EQ(sentence_of([] { rp2040::begin_clocks<Stuck<>>(); }), "The crystal does not start.");
    EXPECT_EQ(sentence_of([] { rp2040::begin_clocks<Stuck<crystal, ready>>(); }), "A part of the chip does not leave its reset.");
    EXPECT_EQ(sentence_of([] { rp2040::begin_clocks<Stuck<crystal, ready, resets, awake>>(); }), "The PLL does not lock.");
    EXPECT_EQ(sentence_of([] { rp2040::begin_clocks<Stuck<crystal, ready, resets, awake, pll, ready>>(); }), "");
}

TEST(Rp2040, SaysWhatNeverEnds) {
    EXPECT_EQ(sentence_of([] { Spi<Stuck<>>().send(1); }), "The display's bus takes no byte.");
    EXPECT_EQ(sentence_of([] { Spi<Stuck<dma, dma_busy>>().wait(); }), "The DMA to the display never ends: does the bus take no bytes?");
    EXPECT_EQ(sentence_of([] { Spi<Stuck<spi_status, spi_busy>>().wait(); }), "The display's bus stays busy.");
    EXPECT_EQ(sentence_of([] { Spi<Stuck<spi_status, may_send | received>>().wait(); }), "") << "what comes back is taken out eight times at most";
    rp2040::delay_ms<Stuck<>>(5);  // a timer that stands still is no hang
}

}  // namespace
}  // namespace shade16::chips
