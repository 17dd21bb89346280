// The board stm32f4_ili9341, its clocks and its display's wires, on a model of the chip and of the panel.
#include <gtest/gtest.h>

#include <apps/turntable_scene.hpp>

#include "tests/chips/shown.hpp"
#include "tests/chips/stm32f4.hpp"

namespace shade16::chips {
namespace {

constexpr Stm32f4::Wiring wiring{.clock = 5, .data = 7, .select = 4, .command = 3, .reset = 1};
using Port = PortTo<Stm32f4>;
template <class P>
using Display = DcsDisplay<Board::Bus<P>, ili9341, Orientation{1}>;

struct Stm32f4Board : ::testing::Test {
    displays::DcsModel panel{ili9341};
    Stm32f4 chip{panel, wiring};
    Stm32f4Board() { Port::chip = &chip; }
};

TEST_F(Stm32f4Board, ItsClocksAreThoseItSays) {
    stm32f4::begin_clocks<Port>();
    EXPECT_EQ(chip.complaint(), "");
    EXPECT_EQ(chip.cpu_hz(), Board::cpu_hz);
    EXPECT_EQ(chip.bus_hz(10), stm32f4::slow_bus_hz);
    EXPECT_EQ(chip.bus_hz(13), stm32f4::fast_bus_hz);
}

TEST_F(Stm32f4Board, ThePanelShowsEveryPixel) {
    stm32f4::begin_clocks<Port>();
    const displays::Seen picture = noise(Board::width_px, Board::height_px);
    Display<Port> display;
    send(display, picture, Board::band_rows);
    expect_shown(chip, panel, picture, Orientation{1});
    EXPECT_EQ(chip.spi_hz(), Board::Bus<Port>::bus_hz);
}

TEST_F(Stm32f4Board, AFrameInOnePieceIsSentInPartsThatTheStreamCounts) {
    stm32f4::begin_clocks<Port>();
    const displays::Seen picture = noise(Board::width_px, Board::height_px);
    Display<Port> display;
    send(display, picture, Board::height_px);
    expect_shown(chip, panel, picture, Orientation{1});
}

TEST_F(Stm32f4Board, ThePanelShowsTheTurntable) {
    stm32f4::begin_clocks<Port>();
    static TurntableWorkspace workspace;
    static BoardBuffer buffers[Board::bands];
    TurntableRenderer renderer(workspace);
    const Pose pose = turntable_pose(7);
    Display<Port> display;
    present(renderer, {.poses = &pose}, screen, buffers, display);
    KeptFrame drawn;
    present(renderer, {.poses = &pose}, screen, buffers, drawn);
    expect_shown(chip, panel, drawn.seen, Orientation{1});
    displays::expect_kept_picture("boards/stm32f4_ili9341", drawn.seen);
}

TEST_F(Stm32f4Board, WhatNeverEndsIsSaid) {
    chip.crystal_is_dead = true;
    EXPECT_EQ(sentence_of([] { stm32f4::begin_clocks<Port>(); }), "The crystal does not start.");
    chip.crystal_is_dead = false;
    stm32f4::begin_clocks<Port>();
    const displays::Seen picture = noise(Board::width_px, Board::height_px);
    Display<Port> display;
    chip.spi_is_dead = true;
    EXPECT_EQ(sentence_of([&] { send(display, picture, Board::band_rows); }), "The display's bus takes no byte: is its clock on?");
}

/// A hundred million tries take the model too long.
struct DeadStream : Port {
    static uint32_t read(uint32_t address) { return address == 0x40026458 && chip->dma_is_dead ? 1 : chip->read(address); }
};
TEST_F(Stm32f4Board, AStreamThatNeverEndsIsSaid) {
    PortTo<Stm32f4>::chip = &chip;
    stm32f4::begin_clocks<DeadStream>();
    const displays::Seen picture = noise(Board::width_px, Board::height_px);
    Display<DeadStream> display;
    chip.dma_is_dead = true;
    EXPECT_EQ(sentence_of([&] { send(display, picture, Board::band_rows); }), "The DMA to the display never ends: does the bus take no bytes?");
}

// What a driver might get wrong, one at a time.

template <uint32_t Address, uint32_t Bits>
using Without = BitsNeverSet<Port, Address, Bits>;
struct NeverBusy : Port {
    static uint32_t read(uint32_t address) { return address == 0x40013008 ? chip->read(address) & ~0x80u : chip->read(address); }
};
struct NeverFull : Port {
    static uint32_t read(uint32_t address) { return address == 0x40013008 ? chip->read(address) | 2 : chip->read(address); }
};

template <class Broken>
std::string complaint_about() {
    return chips::complaint_about<Stm32f4, Display<Broken>>(ili9341, wiring, stm32f4::begin_clocks<Broken>, Board::band_rows);
}

TEST(Stm32f4Driver, MistakesAreFound) {
    EXPECT_EQ((complaint_about<Port>()), "");
    EXPECT_EQ((complaint_about<Without<0x40023844, 1 << 12>>()), "a part of the chip is used before its clock is on");
    EXPECT_EQ((complaint_about<Without<0x40023830, 1>>()), "a part of the chip is used before its clock is on");
    EXPECT_EQ((complaint_about<Without<0x40023C00, 7>>()), "the flash has too few wait states for the processor's clock");
    EXPECT_EQ((complaint_about<Without<0x40020020, 0xF0000000>>()), "SPI has no wires: its lines are not given to it");
    EXPECT_EQ((complaint_about<Without<0x40013000, 1 << 9>>()), "SPI is not on, no master or not selected");
    EXPECT_EQ((complaint_about<Without<0x40026458, 1 << 10>>()), "the stream is not from moving memory to SPI 1, byte by byte");
    EXPECT_EQ((complaint_about<Without<0x40026408, 1 << 27>>()), "the stream is begun with its flags still set");
    EXPECT_EQ((complaint_about<NeverFull>()), "a byte is written over one that waits to be sent");
    EXPECT_NE((complaint_about<NeverBusy>()), "");
}

}  // namespace
}  // namespace shade16::chips
