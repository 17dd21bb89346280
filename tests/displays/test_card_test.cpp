// The test card on every wrong setting, as the model of the display shows it: the pictures of docs/testcard.md.
#include <gtest/gtest.h>

#include <array>
#include <display/st7789.hpp>
#include <display/test_card.hpp>

#include "tests/displays/kept_picture.hpp"
#include "tests/displays/model_bus.hpp"

namespace shade16::displays {
namespace {

constexpr DcsPanel changed(void (*change)(DcsPanel&)) {
    DcsPanel panel = st7789_135x240;
    change(panel);
    return panel;
}
inline constexpr DcsPanel red_and_blue = changed([](DcsPanel& p) { p.blue_first = true; });
inline constexpr DcsPanel not_inverted = changed([](DcsPanel& p) { p.inverted = false; });
inline constexpr DcsPanel no_offset = changed([](DcsPanel& p) { p.first_column = p.first_row = 0; });
inline constexpr DcsPanel mirrored = changed([](DcsPanel& p) { p.columns_mirrored = false; });

/// Words as a little-endian processor has them, sent byte by byte.
struct BytesExchanged : ByteBus {
    using Format = Rgb565;
};

/// The card on the glass of a 135x240 ST7789 whose driver is told something else.
template <const DcsPanel& told, class Bus = ByteBus, Orientation o = Orientation{}>
Seen card_when_told() {
    using Display = DcsDisplay<Bus, told, o>;
    using Format = typename Display::Pixel;
    DcsModel model(st7789_135x240);
    Bus bus;
    bus.model = &model;
    Display display(bus);
    BandBuffer<Format, Display::width_px, Display::height_px, false> buffer;
    const TestCard card{Display::width_px, Display::height_px, {"st7789 135x240", Format::name, "gap 52.40 inverted", "turned 0"}, 15};
    card.draw(buffer.band());
    display.flush({0, 0, Display::width_px, Display::height_px}, buffer.pixels, sizeof(buffer.pixels), true);
    return model.seen();
}

void expect_picture(const std::string& name, const Seen& seen) { expect_kept_picture("testcard/" + name, seen); }

TEST(TestCard, ShowsWhatIsWrong) {
    expect_picture("right", card_when_told<st7789_135x240>());
    expect_picture("bytes_exchanged", card_when_told<st7789_135x240, BytesExchanged>());
    expect_picture("red_and_blue_exchanged", card_when_told<red_and_blue>());
    expect_picture("not_inverted", card_when_told<not_inverted>());
    expect_picture("no_offset", card_when_told<no_offset>());
    expect_picture("upside_down", card_when_told<st7789_135x240, ByteBus, Orientation{2}>());
    expect_picture("mirrored", card_when_told<mirrored>());
}

TEST(TestCard, IsDrawnOnGreysToo) {
    const TestCard card{128, 64, {"ssd0323 128x64", Gray4::name}};
    BandBuffer<Gray4, 128, 64, false> gray;
    card.draw(gray.band());
    EXPECT_EQ(luma_code<Gray4>(gray.band().row(0), 5), 15u);
    EXPECT_EQ(luma_code<Gray4>(gray.band().row(40), 1), 0u);
    EXPECT_EQ(luma_code<Gray4>(gray.band().row(40), 126), 15u);
}

}  // namespace
}  // namespace shade16::displays
