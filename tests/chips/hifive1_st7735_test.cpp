// The board hifive1_st7735, its clocks and its display's wires, on a model of the chip and of the panel.
#include <gtest/gtest.h>

#include <apps/turntable_scene.hpp>

#include "tests/chips/fe310.hpp"
#include "tests/chips/shown.hpp"

namespace shade16::chips {
namespace {

constexpr Fe310::Wiring wiring{.select = 2, .command = 1, .reset = 0};
using Port = PortTo<Fe310>;
template <class P>
using Display = DcsDisplay<Board::Bus<P>, st7735_black_tab>;

struct HiFive1 : ::testing::Test {
    displays::DcsModel panel{st7735_black_tab};
    Fe310 chip{panel, wiring};
    HiFive1() { Port::chip = &chip; }
};

TEST_F(HiFive1, ItsClockIsTheOneItSays) {
    fe310::begin_clocks<Port>();
    EXPECT_EQ(chip.complaint(), "");
    EXPECT_EQ(chip.cpu_hz(), Board::cpu_hz);
}

TEST_F(HiFive1, ALoaderMayHaveLeftThePllOn) {
    fe310::begin_clocks<Port>();
    fe310::begin_clocks<Port>();
    EXPECT_EQ(chip.complaint(), "");
    EXPECT_EQ(chip.cpu_hz(), Board::cpu_hz);
}

TEST_F(HiFive1, ThePanelShowsEveryPixel) {
    fe310::begin_clocks<Port>();
    const displays::Seen picture = noise(Board::width_px, Board::height_px);
    Display<Port> display;
    send(display, picture, Board::band_rows);
    expect_shown(chip, panel, picture, {});
    EXPECT_EQ(chip.spi_hz(), Board::Bus<Port>::bus_hz);
}

TEST_F(HiFive1, ThePanelShowsTheTurntable) {
    fe310::begin_clocks<Port>();
    static TurntableWorkspace workspace;
    static BoardBuffer buffers[Board::bands];
    TurntableRenderer renderer(workspace);
    const Pose pose = turntable_pose(7);
    Display<Port> display;
    present(renderer, {.poses = &pose}, screen, buffers, display);
    KeptFrame drawn;
    present(renderer, {.poses = &pose}, screen, buffers, drawn);
    expect_shown(chip, panel, drawn.seen, Orientation{});
    displays::expect_kept_picture("boards/hifive1_st7735", drawn.seen);
}

TEST_F(HiFive1, WhatNeverEndsIsSaid) {
    chip.crystal_is_dead = true;
    EXPECT_EQ(sentence_of([] { fe310::begin_clocks<Port>(); }), "The crystal does not start.");
    chip.crystal_is_dead = false, chip.pll_is_dead = true;
    EXPECT_EQ(sentence_of([] { fe310::begin_clocks<Port>(); }), "The PLL does not lock.");
    chip.pll_is_dead = false;
    fe310::begin_clocks<Port>();
    Display<Port> display;
    chip.spi_is_dead = true;
    const displays::Seen picture = noise(Board::width_px, Board::height_px);
    EXPECT_EQ(sentence_of([&] { send(display, picture, Board::band_rows); }), "The display's bus does not send: is its clock on?");
}

TEST_F(HiFive1, ATimerThatStandsStillIsNoHang) {
    chip.timer_is_dead = true;
    fe310::delay_ms<Port>(2);
    EXPECT_EQ(chip.complaint(), "");
}

// What a driver might get wrong, one at a time.

template <uint32_t Address, uint32_t Bits>
using Without = BitsNeverSet<Port, Address, Bits>;
struct AlwaysBack : Port {
    static uint32_t read(uint32_t address) { return address == 0x1002404C ? 0 : chip->read(address); }
};
struct NoTime : Port {
    static uint32_t read(uint32_t address) {
        static uint32_t ticks = 0;
        return address == 0x0200BFF8 ? ticks += 100'000 : chip->read(address);
    }
};

template <class Broken>
std::string complaint_about() {
    return chips::complaint_about<Fe310, Display<Broken>>(st7735_black_tab, wiring, fe310::begin_clocks<Broken>, Board::band_rows);
}

TEST(Fe310Driver, MistakesAreFound) {
    EXPECT_EQ((complaint_about<Port>()), "");
    EXPECT_EQ((complaint_about<Without<0x10014000, 3>>()), "the flash is read faster than it can be");
    EXPECT_EQ((complaint_about<Without<0x10012038, 1 << 3>>()), "SPI has no wires: its lines are not given to it");
    EXPECT_EQ((complaint_about<Without<0x10024040, 8 << 16>>()), "SPI does not send eight bits, the highest first, in mode 0, and keep what comes back");
    EXPECT_EQ((complaint_about<Without<0x10024018, 3>>()), "SPI moves a select line of its own");
    EXPECT_EQ((complaint_about<Without<0x10012008, 1 << 2>>()), "a byte is sent and the display is not selected");
    EXPECT_EQ((complaint_about<Without<0x10008008, 1 << 17>>()), "the PLL has no crystal");
    EXPECT_EQ((complaint_about<NoTime>()), "the PLL is selected before it can have locked");
    EXPECT_NE((complaint_about<AlwaysBack>()), "");
    EXPECT_NE((complaint_about<Without<0x1001200C, 1 << 1>>()), "");  // the data/command line stays low
}

}  // namespace
}  // namespace shade16::chips
