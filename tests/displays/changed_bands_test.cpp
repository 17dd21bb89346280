// Only what changed is sent, and the panel shows the same picture.
#include <gtest/gtest.h>

#include <assets/teapot.hpp>
#include <display/changed_bands.hpp>
#include <display/st7789.hpp>
#include <random>

#include "tests/displays/model_bus.hpp"

namespace shade16::displays {
namespace {

constexpr int band_rows = 40;

/// Counts what the wire carries.
struct CountingBus : ByteBus {
    size_t* pixel_bytes = nullptr;
    void pixels(const uint16_t* pixels, size_t count) {
        *pixel_bytes += 2 * count;
        ByteBus::pixels(pixels, count);
    }
};
using Panel = DcsDisplay<CountingBus, st7789_240x240>;

constexpr Light lights[] = {ambient_light(rgb(0x484848)), directional_light({-5, 5, 9}, white, 0.7_scaled)};
constexpr Object objects[] = {{.mesh = assets::teapot, .material = *find_material("brass")}};
constexpr Scene scene{
    .camera = {.eye = {0, 2, 5}, .viewer = Viewer::local, .fov_y = 36_deg, .near_distance = 2, .far_distance = 9},
    .lights = lights, .objects = objects, .background = rgb(0x101820),
};

/// A panel and what was sent to it.
struct Wired {
    DcsModel model{st7789_240x240};
    size_t pixel_bytes = 0;
    CountingBus bus() {
        CountingBus b;
        b.model = &model, b.pixel_bytes = &pixel_bytes;
        return b;
    }
};

TEST(ChangedBands, AStillPictureIsSentOnceAndAMovingOneWhereItMoves) {
    Wired plain, dirty;
    Panel all(plain.bus());
    ChangedBands<Panel, band_rows> changed{Panel(dirty.bus())};
    Workspace<scene, mediump, VertexStore::keep> workspace;
    Renderer<scene> renderer(workspace);
    BandBuffer<Rgb565Swapped, 240, band_rows> buffers[2];
    const Viewport viewport{240, 240};
    const auto sent = [&](uint32_t stop) {
        const Pose pose = centred_pose(assets::teapot, rotate_y(45_deg * stop), Q16::from_raw(65536 / 12));
        const size_t before = dirty.pixel_bytes;
        present(renderer, {.poses = &pose}, viewport, buffers, all);
        present(renderer, {.poses = &pose}, viewport, buffers, changed);
        EXPECT_TRUE(dirty.model.seen() == plain.model.seen());
        EXPECT_EQ(dirty.model.complaint(), "");
        return dirty.pixel_bytes - before;
    };
    const size_t whole = 240 * 240 * 2;
    EXPECT_EQ(sent(0), whole);
    EXPECT_EQ(sent(0), 0u);
    const size_t turned = sent(1);
    EXPECT_GT(turned, 0u);
    EXPECT_LT(turned, whole);  // nothing moves at the top and the bottom
    EXPECT_EQ(sent(1), 0u);
    changed.forget();
    EXPECT_EQ(sent(1), whole);
}

TEST(ChangedBands, AnotherAreaIsPassedOnAndWhatItTouchesIsSentAgain) {
    Wired wired;
    ChangedBands<Panel, band_rows> changed{Panel(wired.bus())};
    std::vector<uint16_t> band(240 * band_rows, 0x1234);
    const auto sent = [&](Area area) {
        const size_t before = wired.pixel_bytes;
        changed.flush(area, band.data(), static_cast<size_t>(area.width * area.height) * 2, false);
        return wired.pixel_bytes - before;
    };
    for (int y = 0; y < 240; y += band_rows) EXPECT_EQ(sent({0, y, 240, band_rows}), band.size() * 2);
    EXPECT_EQ(sent({10, 70, 20, 30}), 1200u);  // rows 70 to 99: the bands at 40 and 80
    EXPECT_EQ(sent({0, 0, 240, band_rows}), 0u);
    EXPECT_EQ(sent({0, 40, 240, band_rows}), band.size() * 2);
    EXPECT_EQ(sent({0, 80, 240, band_rows}), band.size() * 2);
    EXPECT_EQ(sent({0, 120, 240, band_rows}), 0u);
}

TEST(BandMark, OneOtherPixelIsAlwaysAnotherMark) {
    std::mt19937 engine(11);
    std::vector<uint16_t> band(1000);
    for (uint16_t& pixel : band) pixel = static_cast<uint16_t>(engine());
    const BandMark mark = BandMark::of(band.data(), band.size() * 2);
    EXPECT_FALSE(mark == BandMark{});
    for (uint16_t& pixel : band) {
        const uint16_t was = pixel;
        for (int bit = 0; bit < 16; ++bit) {
            pixel = static_cast<uint16_t>(was ^ 1 << bit);
            ASSERT_FALSE(BandMark::of(band.data(), band.size() * 2) == mark);
        }
        pixel = was;
    }
    std::swap(band[3], band[700]);
    EXPECT_FALSE(BandMark::of(band.data(), band.size() * 2) == mark);
}

}  // namespace
}  // namespace shade16::displays
