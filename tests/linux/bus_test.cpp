// A display driven line by line: what its wires carry, read as the display reads them.
#include "boards/linux_spi/bit_banged_spi.hpp"
#include "boards/linux_spi/linux_bus.hpp"

#include <gtest/gtest.h>

#include <display/st7735.hpp>
#include <functional>
#include <random>

#include "host_sim/error.hpp"
#include "tests/linux/fake_chips.hpp"
#include "tests/linux/wire_reader.hpp"

namespace shade16::linux_spi {
namespace {

static_assert(DisplayBus<LinuxBus<ByteSender>>);
static_assert(DisplayBus<LinuxBus<BitBangedSpi<>>>);

/// Wires by their names; each change is read by the display.
struct Wires {
    bool clock = false, data = false, select = true, command = false, reset = true, backlight = false;
    int changes = 0, fails_at = 0;
    std::function<void(const Wires&, const bool&)> changed{};
};
struct Wire {
    Wires* wires;
    bool Wires::*which;
    void set(bool high) {
        if (++wires->changes == wires->fails_at) throw host::io_error("line 'x': its chip is gone.");
        wires->*which = high;
        if (wires->changed) wires->changed(*wires, wires->*which);
    }
};

struct Panel {
    explicit Panel(Wires& w, PanelLines<Wire>::AtEnd at_end = PanelLines<Wire>::AtEnd::dark)
        : spi({&w, &Wires::clock}, {&w, &Wires::data}, Wire{&w, &Wires::select}),
          lines({&w, &Wires::command}, Wire{&w, &Wires::reset}, Wire{&w, &Wires::backlight}, at_end) {}
    BitBangedSpi<Wire> spi;
    PanelLines<Wire> lines;
    using Bus = LinuxBus<BitBangedSpi<Wire>, Wire>;
    Bus bus{spi, lines};
};

TEST(BitBangedSpi, SendsTheHighBitFirstAndDataBeforeTheClockRises) {
    Wires wires;
    std::string bits;
    wires.changed = [&](const Wires& w, const bool& which) {
        if (&which == &w.clock && w.clock) bits += w.data ? '1' : '0';
        EXPECT_FALSE(&which == &w.data && w.clock) << "data changed while the clock was high";
    };
    {
        BitBangedSpi<Wire> spi({&wires, &Wires::clock}, {&wires, &Wires::data}, Wire{&wires, &Wires::select});
        EXPECT_FALSE(wires.select);
        const uint8_t bytes[] = {0xA5, 0x00, 0xFF, 0x01};
        spi.send(bytes, sizeof(bytes));
        EXPECT_FALSE(wires.clock);
    }
    EXPECT_TRUE(wires.select);
    EXPECT_EQ(bits, "10100101" "00000000" "11111111" "00000001");
}

TEST(LinuxBus, ShowsAPictureOnASmallPanel) {
    Wires wires;
    displays::DcsModel model(st7735_80x160);
    WireReader reader(model);
    wires.changed = [&](const Wires& w, const bool& which) {
        if (&which == &w.reset) reader.reset(w.reset);
        if (&which == &w.clock && w.clock && !w.select) reader.clock_rises(w.command, w.data);
    };
    std::vector<uint16_t> pixels;
    std::mt19937 engine(7);
    for (int i = 0; i < 80 * 160; ++i) pixels.push_back(static_cast<uint16_t>(engine()));
    {
        Panel panel(wires);
        DcsDisplay<Panel::Bus, st7735_80x160> display(panel.bus);
        EXPECT_FALSE(wires.backlight) << "nothing is there to see";
        std::vector<uint16_t> swapped;
        for (const uint16_t p : pixels) swapped.push_back(Rgb565Swapped::from_rgb565(p));
        display.flush({0, 0, 80, 160}, swapped.data(), swapped.size() * 2, true);
        display.wait();
        EXPECT_TRUE(wires.backlight);
    }
    EXPECT_FALSE(wires.backlight) << "dark at the end";
    model.end();
    EXPECT_EQ(model.complaint(), "");
    EXPECT_TRUE(model.seen().pixels == pixels);
}

TEST(LinuxBus, LeavesTheLightOnWhenAsked) {
    Wires wires;
    {
        Panel panel(wires, PanelLines<Wire>::AtEnd::as_it_is);
        const Rgb565Swapped::Pixel pixel{};
        panel.bus.pixels(&pixel, 1);
    }
    EXPECT_TRUE(wires.backlight);
}

TEST(LinuxBus, AFailureLeavesItDarkToo) {
    Wires wires;
    const auto fails = [&] {
        Panel panel(wires);
        const Rgb565Swapped::Pixel pixel{};
        panel.bus.pixels(&pixel, 1);
        EXPECT_TRUE(wires.backlight);
        wires.fails_at = wires.changes + 1;
        panel.bus.command(0);
    };
    EXPECT_THROW(fails(), host::Error);
    EXPECT_FALSE(wires.backlight);
    EXPECT_TRUE(wires.select);
}

/// A bus of real OutputLines, at whichever change its chip goes: the sentence arrives, and every line is given back.
class BusOfLines : public FakeChips {};

TEST_F(BusOfLines, GivesAllBackWhereverItsChipGoes) {
    const LineOptions options{.devices = folder()};
    for (int last = 1; last < 60; ++last) {
        const std::string said = host::complaint([&] {
            BitBangedSpi<> spi(OutputLine("GPIO11", options), OutputLine("GPIO10", options), OutputLine("GPIO8", options));
            PanelLines<> lines(OutputLine("GPIO25", options), OutputLine("GPIO27", options), OutputLine("GPIO18", options));
            LinuxBus<BitBangedSpi<>> bus(spi, lines);
            fake.step = 0, fake.fail_at = last, fake.fail_with = ENODEV;
            bus.command(dcs::write_memory), bus.command(dcs::write_memory), bus.command(dcs::write_memory);
        });
        fake.fail_at = 0;
        EXPECT_NE(said.find("is gone"), std::string::npos) << last << ": " << said;
        for (const unsigned offset : {8u, 10u, 11u, 18u, 25u, 27u}) EXPECT_EQ(line(offset).requested, line(offset).released);
    }
    EXPECT_EQ(line(25).requested, 59);
}

}  // namespace
}  // namespace shade16::linux_spi
