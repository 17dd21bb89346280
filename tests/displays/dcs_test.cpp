// The drivers of the Display Command Set against the strict model: every panel, every way up, and what happens when a driver errs.
#include <gtest/gtest.h>

#include <array>
#include <display/gc9a01.hpp>
#include <display/ili9341.hpp>
#include <display/st7735.hpp>
#include <display/st7789.hpp>
#include <random>

#include "tests/displays/model_bus.hpp"
#include "tests/displays/turned.hpp"

namespace shade16::displays {
namespace {

/// Noise: any exchange of pixels, bits or bytes shows.
Seen noise(int width, int height) {
    Seen picture{width, height, {}};
    std::mt19937 engine(7);
    for (int i = 0; i < width * height; ++i) picture.pixels.push_back(static_cast<uint16_t>(engine()));
    return picture;
}

/// Sends a picture in bands of 40 rows.
template <class Display>
void send(Display& display, const Seen& picture) {
    std::vector<typename Display::Pixel::Pixel> band;
    for (int y = 0; y < picture.height; y += 40) {
        const int rows = std::min(40, picture.height - y);
        band.clear();
        for (int i = y * picture.width; i < (y + rows) * picture.width; ++i)
            band.push_back(Display::Pixel::from_rgb565(picture.pixels[static_cast<size_t>(i)]));
        display.flush({0, y, picture.width, rows}, band.data(), band.size() * 2, y + rows == picture.height);
        display.wait();
    }
}

template <class Bus, const DcsPanel& panel, Orientation o>
void expect_the_picture() {
    using Display = DcsDisplay<Bus, panel, o>;
    DcsModel model(panel);
    Bus bus;
    bus.model = &model;
    Display display(bus);
    const Seen picture = noise(Display::width_px, Display::height_px);
    send(display, picture);
    model.end();
    EXPECT_EQ(model.complaint(), "") << panel.name << " turned " << o.quarter_turns;
    EXPECT_TRUE(model.seen() == turned(picture, o)) << panel.name << " turned " << o.quarter_turns << (o.mirrored ? ", mirrored" : "");
}

template <class Bus, const DcsPanel& panel>
void expect_every_way_up() {
    expect_the_picture<Bus, panel, Orientation{0, false}>(), expect_the_picture<Bus, panel, Orientation{0, true}>();
    expect_the_picture<Bus, panel, Orientation{1, false}>(), expect_the_picture<Bus, panel, Orientation{1, true}>();
    expect_the_picture<Bus, panel, Orientation{2, false}>(), expect_the_picture<Bus, panel, Orientation{2, true}>();
    expect_the_picture<Bus, panel, Orientation{3, false}>(), expect_the_picture<Bus, panel, Orientation{3, true}>();
}

TEST(Dcs, EveryPanelShowsThePictureEveryWayUp) {
    expect_every_way_up<ByteBus, ili9341>();
    expect_every_way_up<ByteBus, st7789>();
    expect_every_way_up<ByteBus, st7789_240x240>();
    expect_every_way_up<ByteBus, st7789_135x240>();
    expect_every_way_up<ByteBus, st7735_black_tab>();
    expect_every_way_up<ByteBus, st7735_green_tab>();
    expect_every_way_up<ByteBus, st7735_128x128>();
    expect_every_way_up<ByteBus, st7735_80x160>();
    expect_every_way_up<ByteBus, st7735_80x160_plug_in>();
    expect_every_way_up<ByteBus, gc9a01>();
    expect_every_way_up<WordBus, st7789>();
}

// Source: what Adafruit_ILI9341, Adafruit-ST7735-Library and TFT_eSPI write for rotations 0 to 3.
TEST(Dcs, MemoryAccessIsWhatOtherDriversWrite) {
    const auto access = [](const DcsPanel& panel) {
        std::array<int, 4> of{};
        for (int turns = 0; turns < 4; ++turns) of[static_cast<size_t>(turns)] = dcs::access_of(panel, {turns});
        return of;
    };
    EXPECT_EQ(access(ili9341), (std::array{0x48, 0x28, 0x88, 0xE8}));
    EXPECT_EQ(access(st7789), (std::array{0xC0, 0xA0, 0x00, 0x60}));
    EXPECT_EQ(access(st7735_black_tab), (std::array{0xC0, 0xA0, 0x00, 0x60}));
    EXPECT_EQ(access(st7735_green_tab), (std::array{0xC8, 0xA8, 0x08, 0x68}));
    EXPECT_EQ(access(gc9a01), (std::array{0x08, 0x68, 0xC8, 0xA8}));
}

TEST(Dcs, GapsAreThoseOfOtherDrivers) {
    const auto gaps = [](const DcsPanel& panel) {
        std::array<std::array<int, 2>, 4> of{};
        for (int turns = 0; turns < 4; ++turns) {
            const dcs::Gap gap = dcs::gap_of(panel, {turns});
            of[static_cast<size_t>(turns)] = {gap.x, gap.y};
        }
        return of;
    };
    using Gaps = std::array<std::array<int, 2>, 4>;
    EXPECT_EQ(gaps(st7789), (Gaps{{{0, 0}, {0, 0}, {0, 0}, {0, 0}}}));
    EXPECT_EQ(gaps(st7789_240x240), (Gaps{{{0, 80}, {80, 0}, {0, 0}, {0, 0}}}));
    EXPECT_EQ(gaps(st7789_135x240), (Gaps{{{53, 40}, {40, 52}, {52, 40}, {40, 53}}}));
    EXPECT_EQ(gaps(st7735_green_tab), (Gaps{{{2, 1}, {1, 2}, {2, 1}, {1, 2}}}));
    EXPECT_EQ(gaps(st7735_128x128), (Gaps{{{2, 3}, {3, 2}, {2, 1}, {1, 2}}}));
    EXPECT_EQ(gaps(st7735_80x160), (Gaps{{{24, 0}, {0, 24}, {24, 0}, {0, 24}}}));
    EXPECT_EQ(gaps(st7735_80x160_plug_in), (Gaps{{{26, 1}, {1, 26}, {26, 1}, {1, 26}}}));
}

// What a driver might get wrong, one at a time, on the panel whose memory is larger than its glass.

struct NoReset : ByteBus {
    void reset() {}
};
struct NoDelayAfterReset : ByteBus {
    void reset() { model->reset_line(false), model->reset_line(true); }
};
struct NoDelays : ByteBus {
    void delay_ms(uint32_t) {}
};
struct CommandsAsData : ByteBus {
    void command(uint8_t byte) {
        if (byte == dcs::rows) model->data(byte);
        else model->command(byte);
    }
};
struct WrongPixelFormat : ByteBus {
    uint8_t last = 0;
    void command(uint8_t byte) { model->command(last = byte); }
    void data(const uint8_t* bytes, size_t count) {
        const uint8_t eighteen_bits = 0x66;
        ByteBus::data(last == dcs::pixel_format ? &eighteen_bits : bytes, count);
    }
};
struct WindowOneFurther : ByteBus {
    uint8_t last = 0;
    void command(uint8_t byte) { model->command(last = byte); }
    void data(const uint8_t* bytes, size_t count) {
        std::array<uint8_t, 4> moved{};
        if (last != dcs::columns || count != 4) return ByteBus::data(bytes, count);
        for (size_t i = 0; i < 4; i += 2) {
            const int at = (bytes[i] << 8 | bytes[i + 1]) + 1;
            moved[i] = static_cast<uint8_t>(at >> 8), moved[i + 1] = static_cast<uint8_t>(at);
        }
        ByteBus::data(moved.data(), 4);
    }
};
struct WindowOneLess : ByteBus {
    uint8_t last = 0;
    void command(uint8_t byte) { model->command(last = byte); }
    void data(const uint8_t* bytes, size_t count) {
        if (last != dcs::columns || count != 4) return ByteBus::data(bytes, count);
        const std::array<uint8_t, 4> shorter{bytes[0], bytes[1], bytes[2], static_cast<uint8_t>(bytes[3] - 1)};
        ByteBus::data(shorter.data(), 4);
    }
};
struct OnePixelLess : ByteBus {
    void pixels(const uint16_t* pixels, size_t count) { ByteBus::pixels(pixels, count - 1); }
};
struct OneByteLess : ByteBus {
    void pixels(const uint16_t* pixels, size_t count) { data(reinterpret_cast<const uint8_t*>(pixels), 2 * count - 1); }
};
template <uint8_t Left>
struct Without : ByteBus {
    void command(uint8_t byte) {
        if (byte != Left) model->command(byte);
    }
};
struct ShortWindow : ByteBus {
    void data(const uint8_t* bytes, size_t count) { ByteBus::data(bytes, count == 4 ? 3 : count); }
};

template <class Bus>
std::string complaint_about() {
    DcsModel model(st7789_135x240);
    Bus bus;
    bus.model = &model;
    DcsDisplay<Bus, st7789_135x240> display(bus);
    send(display, noise(135, 240));
    model.end();
    return model.complaint();
}

TEST(Dcs, EveryMistakeHasItsSentence) {
    EXPECT_EQ(complaint_about<ByteBus>(), "");
    EXPECT_EQ(complaint_about<NoReset>(), "command 0x01 came before the display was reset");
    EXPECT_EQ(complaint_about<NoDelayAfterReset>(), "command 0x01 came 120 ms too early after a reset or sleep out");
    EXPECT_EQ(complaint_about<NoDelays>(), "command 0x11 came 5 ms too early after a reset or sleep out");
    EXPECT_EQ(complaint_about<CommandsAsData>(), "command 0x2A takes 4 parameters, and more came: was the data/command line low?");
    EXPECT_EQ(complaint_about<WrongPixelFormat>(), "pixels of 16 bits came, and the pixel format is 0x66");
    EXPECT_EQ(complaint_about<WindowOneFurther>(), "column 134 of row 0 of the glass shows what was there before");
    EXPECT_EQ(complaint_about<WindowOneLess>(), "more pixels came than the window has");
    EXPECT_EQ(complaint_about<OnePixelLess>(), "the window has 5400 pixels, and 5399 came");
    EXPECT_EQ(complaint_about<OneByteLess>(), "a pixel ended after its first byte");
    EXPECT_EQ(complaint_about<Without<dcs::sleep_out>>(), "the display was switched on while it slept");
    EXPECT_EQ(complaint_about<Without<dcs::display_on>>(), "the display was never switched on");
    EXPECT_EQ(complaint_about<ShortWindow>(), "command 0x2A takes 4 parameters, and 3 came");
}

// Mistakes that a display forgives, and an eye does not.

inline constexpr DcsPanel other_subpixels = [] {
    DcsPanel panel = st7789_135x240;
    panel.blue_first = true;
    return panel;
}();
inline constexpr DcsPanel no_ips = [] {
    DcsPanel panel = st7789_135x240;
    panel.inverted = false;
    return panel;
}();
inline constexpr DcsPanel no_offset = [] {
    DcsPanel panel = st7789_135x240;
    panel.first_column = panel.first_row = 0;
    return panel;
}();

template <const DcsPanel& told, class Bus = ByteBus>
Seen seen_when_told() {
    DcsModel model(st7789_135x240);
    Bus bus;
    bus.model = &model;
    DcsDisplay<Bus, told> display(bus);
    send(display, noise(135, 240));
    return model.seen();
}

/// Sends words as a little-endian processor has them.
struct BytesExchanged : ByteBus {
    using Format = Rgb565;
};

TEST(Dcs, WrongSettingsShow) {
    const Seen right = noise(135, 240);
    const auto with = [&right](auto change) {
        Seen picture = right;
        for (uint16_t& p : picture.pixels) p = static_cast<uint16_t>(change(p));
        return picture;
    };
    EXPECT_TRUE(seen_when_told<st7789_135x240>() == right);
    EXPECT_TRUE(seen_when_told<no_ips>() == with([](uint16_t p) { return ~p; }));
    EXPECT_TRUE(seen_when_told<other_subpixels>() == with([](uint16_t p) { return p << 11 | (p & 0x07E0) | p >> 11; }));
    EXPECT_TRUE((seen_when_told<st7789_135x240, BytesExchanged>() == with([](uint16_t p) { return p << 8 | p >> 8; })));
    EXPECT_FALSE(seen_when_told<no_offset>() == right);
}

}  // namespace
}  // namespace shade16::displays
