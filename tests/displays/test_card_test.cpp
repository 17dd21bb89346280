// The test card on every wrong setting, as the model of the display shows it: the pictures of docs/testcard.md.
// SHADE16_WRITE_PICTURES=1 draws them anew.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <display/st7789.hpp>
#include <display/test_card.hpp>

#include "host_sim/io/frame_writer.hpp"
#include "host_sim/io/png_reader.hpp"
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

host::Image as_image(const Seen& seen) {
    host::Image image{seen.width, seen.height};
    const auto widened = [](int code, int most) { return static_cast<uint8_t>((code * 255 + most / 2) / most); };
    for (const uint16_t p : seen.pixels)
        for (const uint8_t byte : {widened(p >> 11, 31), widened(p >> 5 & 63, 63), widened(p & 31, 31)}) image.rgb.push_back(byte);
    return image;
}

void expect_picture(const std::string& name, const Seen& seen) {
    const std::string path = std::string(SHADE16_DOCS) + "/img/testcard/" + name + ".png";
    const host::Image image = as_image(seen);
    if (std::getenv("SHADE16_WRITE_PICTURES") != nullptr) {
        const auto writer = host::open_png_writer(path, image.width, image.height, 1);
        writer->write(image), writer->finish();
    }
    EXPECT_TRUE(host::read_png(path).rgb == image.rgb) << path << " shows another picture; SHADE16_WRITE_PICTURES=1 draws it anew.";
}

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
