// Canvas: a picture that is put together of pictures, rectangles and words.
#pragma once

#include <string_view>

#include "host_sim/io/image.hpp"
#include "shade16/target/pixel.hpp"

namespace shade16::host {

using Ink24 = Rgb888::Pixel;

inline constexpr Ink24 paper{16, 24, 32}, letters{220, 226, 232}, faint{112, 124, 136};

class Canvas {
public:
    Canvas(int width, int height, Ink24 color = paper);

    const Image& image() const { return image_; }

    /// What lies outside is left out, here and below.
    void dot(int x, int y, Ink24 color);
    void fill(int x, int y, int width, int height, Ink24 color);
    void put(const Image& picture, int x, int y);
    void write(std::string_view text, int x, int y, Ink24 color = letters);

private:
    Image image_;
};

/// The width of so many letters, in pixels.
int text_width_px(std::string_view text);

}  // namespace shade16::host
