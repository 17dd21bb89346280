// What the tests of a board's wires do: send a picture and look at the panel.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/chips/chip.hpp"
#include "tests/displays/kept_picture.hpp"
#include "tests/displays/turned.hpp"

namespace shade16::chips {

/// Any exchange of pixels, bits or bytes shows.
inline displays::Seen noise(int width, int height) {
    displays::Seen picture{width, height, {}};
    std::mt19937 engine(7);
    for (int i = 0; i < width * height; ++i) picture.pixels.push_back(static_cast<uint16_t>(engine()));
    return picture;
}

/// Sends a picture in bands, two buffers in turn, as present() does. A buffer that is free again is written over at once.
template <class Display>
void send(Display& display, const displays::Seen& picture, int band_rows) {
    std::vector<typename Display::Pixel::Pixel> buffers[2];
    int turn = 0;
    for (int y = 0; y < picture.height; y += band_rows, turn = 1 - turn) {
        const int rows = std::min(band_rows, picture.height - y);
        auto& band = buffers[turn];
        band.clear();
        for (int i = y * picture.width; i < (y + rows) * picture.width; ++i) band.push_back(Display::Pixel::from_rgb565(picture.pixels[static_cast<size_t>(i)]));
        display.wait();
        std::fill(buffers[1 - turn].begin(), buffers[1 - turn].end(), 0);
        display.flush({0, y, picture.width, rows}, band.data(), band.size() * 2, y + rows == picture.height);
    }
    display.wait();
}

template <class Chip>
void expect_shown(const Chip& chip, displays::DcsModel& panel, const displays::Seen& picture, Orientation o) {
    panel.end();
    EXPECT_EQ(chip.complaint(), "");
    EXPECT_EQ(panel.complaint(), "");
    EXPECT_TRUE(panel.seen() == displays::turned(picture, o));
}

/// A sink that keeps the frame.
struct KeptFrame {
    displays::Seen seen{};
    void flush(Area area, const uint16_t* pixels, size_t bytes, bool) {
        seen.width = area.width, seen.height = area.y + area.height;
        for (size_t i = 0; i < bytes / 2; ++i) seen.pixels.push_back(Rgb565Swapped::swapped(pixels[i]));
    }
    void wait() {}
};

/// Registers some of whose bits are never set.
template <class Port, uint32_t Address, uint32_t Bits>
struct BitsNeverSet : Port {
    static void write(uint32_t address, uint32_t value) { Port::write(address, address == Address ? value & ~Bits : value); }
};

/// What the models of chip and panel say about a driver. `begin_clocks` and `Display` are the driver's, on registers that may be broken.
template <class Chip, class Display>
std::string complaint_about(const DcsPanel& glass, const typename Chip::Wiring& wiring, void (*begin_clocks)(), int band_rows) {
    displays::DcsModel panel(glass);
    Chip chip(panel, wiring);
    PortTo<Chip>::chip = &chip;
    begin_clocks();
    Display display;
    send(display, noise(Display::width_px, Display::height_px), band_rows);
    panel.end();
    return chip.complaint().empty() ? panel.complaint() : chip.complaint();
}

/// What a driver says when it gives up.
template <class Action>
std::string sentence_of(Action action) {
    try {
        action();
    } catch (const Stopped& stopped) {
        return stopped.what();
    }
    return "";
}

}  // namespace shade16::chips
