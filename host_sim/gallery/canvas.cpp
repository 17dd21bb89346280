#include "host_sim/gallery/canvas.hpp"

#include "host_sim/gallery/font.hpp"

namespace shade16::host {

Canvas::Canvas(int width, int height, Ink24 color) {
    image_.width = width, image_.height = height;
    image_.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    fill(0, 0, width, height, color);
}

void Canvas::dot(int x, int y, Ink24 color) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width);
    uint8_t* const to = image_.rgb.data() + 3 * (row + static_cast<std::size_t>(x));
    to[0] = color.r, to[1] = color.g, to[2] = color.b;
}

void Canvas::fill(int x, int y, int width, int height, Ink24 color) {
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) dot(x + i, y + j, color);
}

void Canvas::put(const Image& picture, int x, int y) {
    const uint8_t* from = picture.rgb.data();
    for (int j = 0; j < picture.height; ++j)
        for (int i = 0; i < picture.width; ++i, from += 3) dot(x + i, y + j, {from[0], from[1], from[2]});
}

void Canvas::write(std::string_view text, int x, int y, Ink24 color) {
    for (const char c : text) {
        for (int i = 0; i < glyph_width_px; ++i)
            for (int j = 0; j < glyph_rows_px; ++j)
                if (glyph_of(c)[static_cast<std::size_t>(i)] >> j & 1) dot(x + i, y + j, color);
        x += glyph_pitch_px;
    }
}

int text_width_px(std::string_view text) {
    return text.empty() ? 0 : static_cast<int>(text.size()) * glyph_pitch_px - (glyph_pitch_px - glyph_width_px);
}

}  // namespace shade16::host
