// Pictures of what models of displays show, kept in docs/img. SHADE16_WRITE_PICTURES=1 draws them anew.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "host_sim/io/frame_writer.hpp"
#include "host_sim/io/png_reader.hpp"
#include "tests/displays/dcs_model.hpp"

namespace shade16::displays {

inline host::Image as_image(const Seen& seen) {
    host::Image image{seen.width, seen.height};
    const auto widened = [](int code, int most) { return static_cast<uint8_t>((code * 255 + most / 2) / most); };
    for (const uint16_t p : seen.pixels)
        for (const uint8_t byte : {widened(p >> 11, 31), widened(p >> 5 & 63, 63), widened(p & 31, 31)}) image.rgb.push_back(byte);
    return image;
}

/// `name` is the picture's below docs/img, without its ending.
inline void expect_kept_picture(const std::string& name, const Seen& seen) {
    const std::string path = std::string(SHADE16_DOCS) + "/img/" + name + ".png";
    const host::Image image = as_image(seen);
    if (std::getenv("SHADE16_WRITE_PICTURES") != nullptr) {
        const auto writer = host::open_png_writer(path, image.width, image.height, 1);
        writer->write(image), writer->finish();
    }
    EXPECT_TRUE(host::read_png(path).rgb == image.rgb) << path << " shows another picture; SHADE16_WRITE_PICTURES=1 draws it anew.";
}

}  // namespace shade16::displays
