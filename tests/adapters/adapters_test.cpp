// The adapters against stubs with the libraries' real signatures: a scene in two bands must arrive as it was drawn.
#include <gtest/gtest.h>

#include <adapters/adafruit_spitft.hpp>
#include <adapters/arduino_gfx.hpp>
#include <adapters/esp_lcd.hpp>
#include <adapters/lovyangfx.hpp>
#include <adapters/lvgl.hpp>
#include <adapters/tft_espi.hpp>
#include <adapters/zephyr.hpp>

namespace shade16 {
namespace {

constexpr Light lights[] = {ambient_light(rgb(0x404040)), directional_light({-5, 5, 9}, white, 0.7_scaled)};
constexpr Object objects[] = {{.mesh = sphere<12, 8>.mesh(), .material = *find_material("brass")}};
constexpr Scene scene{
    .camera = {.eye = {0, 0, 4}, .fov_y = 40_deg, .near_distance = 1, .far_distance = 9},
    .lights = lights,
    .objects = objects,
    .background = rgb(0x101820),
};
constexpr Viewport screen{48, 32};

/// The frame as RGB565 codes, drawn at once.
std::vector<uint16_t> expected() {
    Workspace<scene, mediump> workspace;
    Renderer<scene> renderer(workspace);
    Framebuffer<Rgb565, 48, 32> frame;
    renderer.begin({}, screen);
    renderer.draw(frame.band());
    return {std::begin(frame.pixels), std::end(frame.pixels)};
}

/// Two frames, in two bands in turn: each must be gone before it is drawn over.
template <class S>
void present_to(S& sink) {
    static_assert(Sink<S, typename S::Pixel>);
    Workspace<scene, mediump> workspace;
    Renderer<scene> renderer(workspace);
    BandBuffer<typename S::Pixel, 48, 12> bands[2];
    for (int frame = 0; frame < 2; ++frame) present(renderer, Frame{}, screen, bands, sink);
}

TEST(Adapters, TftEspi) {
    TFT_eSPI tft;
    TftEspiSink sink(tft);
    sink.begin();
    present_to(sink);
    EXPECT_FALSE(tft.screen.wrong);
    EXPECT_EQ(tft.screen.codes, expected());
}

TEST(Adapters, LovyanGfx) {
    lgfx::LGFX_Device lcd;
    LovyanSink sink(lcd);
    sink.begin();
    present_to(sink);
    EXPECT_FALSE(lcd.screen.wrong);
    EXPECT_EQ(lcd.screen.codes, expected());
}

TEST(Adapters, AdafruitSpiTft) {
    Adafruit_SPITFT tft;
    AdafruitSink sink(tft);
    present_to(sink);
    EXPECT_FALSE(tft.screen.wrong);
    EXPECT_FALSE(tft.is_open);
    EXPECT_EQ(tft.screen.codes, expected());
}

TEST(Adapters, ArduinoGfx) {
    Arduino_GFX gfx;
    ArduinoGfxSink sink(gfx);
    present_to(sink);
    EXPECT_FALSE(gfx.screen.wrong);
    EXPECT_EQ(gfx.screen.codes, expected());
}

TEST(Adapters, EspLcd) {
    esp_lcd_panel_io_t io{};
    esp_lcd_panel_t panel;
    panel.io = &io;
    EspLcdSink sink(&panel);
    sink.begin(&io);
    present_to(sink);
    EXPECT_FALSE(sink.failed());
    EXPECT_EQ(panel.screen.codes, expected());
}

TEST(Adapters, Zephyr) {
    stub::Screen zephyr_screen;
    device display{&zephyr_screen, 0};
    ZephyrSink sink(&display);
    present_to(sink);
    EXPECT_FALSE(sink.failed());
    EXPECT_EQ(display.frames, 2);
    EXPECT_EQ(zephyr_screen.codes, expected());
}

TEST(Adapters, LvglCanvas) {
    lv_obj_t object{};
    LvglCanvas<48, 32> canvas;
    canvas.begin(&object);
    Workspace<scene, mediump> workspace;
    Renderer<scene> renderer(workspace);
    canvas.show(renderer, Frame{});
    const auto* const pixels = static_cast<const uint16_t*>(object.buffer);
    EXPECT_EQ(object.format, LV_COLOR_FORMAT_RGB565);
    EXPECT_EQ(object.invalidated, 1);
    EXPECT_EQ(std::vector<uint16_t>(pixels, pixels + 48 * 32), expected());
}

/// A sink that keeps what it shows.
struct Panel {
    using Pixel = Rgb565Swapped;
    stub::Screen screen{};
    int frames = 0;
    void flush(Area a, const uint16_t* pixels, size_t, bool last) {
        screen.put(a.x, a.y, a.width, a.height, pixels);
        frames += last ? 1 : 0;
    }
    void wait() {}
};

TEST(Adapters, LvglDisplay) {
    Panel panel;
    lv_display_t display{};
    LvglDisplay<Panel>::attach(&display, panel);
    EXPECT_EQ(display.format, LV_COLOR_FORMAT_RGB565_SWAPPED);
    uint8_t pixels[2 * 4 * 3];
    for (size_t i = 0; i < sizeof(pixels); ++i) pixels[i] = static_cast<uint8_t>(i);
    const lv_area_t area{5, 6, 8, 8};  // four columns and three rows, ends included
    display.is_last = true;
    display.flush(&display, &area, pixels);
    EXPECT_EQ(display.ready, 1);
    EXPECT_EQ(panel.frames, 1);
    EXPECT_EQ(panel.screen.codes[6 * 48 + 5], 0x0001);
    EXPECT_EQ(panel.screen.codes[8 * 48 + 8], 0x1617);
    EXPECT_EQ(panel.screen.codes[8 * 48 + 9], 0);
}

}  // namespace
}  // namespace shade16
