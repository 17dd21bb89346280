// A panel of few pixels, for tests of many frames, and pictures of its size.
#pragma once

#include <display/ili9341.hpp>
#include <random>
#include <vector>

#include "host_sim/io/image.hpp"
#include "host_sim/screen/panel_by_name.hpp"
#include "tests/displays/dcs_model.hpp"

namespace shade16::linux_spi {

inline constexpr int small_width = 24, small_height = 16;

inline host::Panel small_panel() {
    static const host::Panel panel = [] {
        DcsPanel small = ili9341;
        small.width_px = small.memory_width_px = small_width, small.height_px = small.memory_height_px = small_height;
        return std::make_shared<const DcsPanel>(small);
    }();
    return panel;
}

/// Noise, as the bytes that a panel takes and as the codes that it then shows.
class Picture {
public:
    explicit Picture(unsigned seed) : random_(seed) {
        image_.raw.resize(2 * small_width * small_height);
        for (int y = 0; y < small_height; ++y) change_row(y);
    }
    void change_row(int y) {
        for (int i = 0; i < 2 * small_width; ++i) image_.raw[static_cast<std::size_t>(2 * small_width * y + i)] = static_cast<uint8_t>(random_());
    }
    const host::Image& image() const { return image_; }
    std::vector<uint16_t> codes() const {
        std::vector<uint16_t> codes;
        for (std::size_t i = 0; i < image_.raw.size(); i += 2) codes.push_back(static_cast<uint16_t>(image_.raw[i] << 8 | image_.raw[i + 1]));
        return codes;
    }

private:
    std::mt19937 random_;
    host::Image image_{small_width, small_height, {}, {}, 0};
};

inline std::vector<uint16_t> seen_on(const displays::DcsModel& display) { return display.seen().pixels; }

}  // namespace shade16::linux_spi
