#include "host_sim/cli/half_blocks.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace shade16::host {

namespace {

using Color = std::array<uint8_t, 3>;

/// The pixel, or the one above it where the last row of text has only one row of pixels.
Color pixel(const Image& image, int x, int y) {
    const std::size_t row = static_cast<std::size_t>(std::min(y, image.height - 1));
    const std::size_t at = 3 * (row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

/// The line of text that shows rows y and y + 1. A colour is said only where it changes.
std::string line_of_blocks(const Image& image, int y) {
    std::string line;
    Color upper_before{}, lower_before{};
    for (int x = 0; x < image.width; ++x) {
        const Color upper = pixel(image, x, y), lower = pixel(image, x, y + 1);
        if (x == 0 || upper != upper_before) line += fmt::format("\033[38;2;{}m", fmt::join(upper, ";"));
        if (x == 0 || lower != lower_before) line += fmt::format("\033[48;2;{}m", fmt::join(lower, ";"));
        line += "\u2580";  // upper half block
        upper_before = upper, lower_before = lower;
    }
    return line + "\033[0m\n";
}

/// A weighted sum that need not be exact: ten letters follow.
int brightness(const Color& c) { return (2 * c[0] + 5 * c[1] + c[2]) / 8; }

}  // namespace

std::string half_blocks(const Image& image) {
    std::string text;
    for (int y = 0; y < image.height; y += 2) text += line_of_blocks(image, y);
    return text;
}

std::string shades_of_letters(const Image& image) {
    constexpr std::string_view letters = " .:-=+*#%@";
    std::string text;
    for (int y = 0; y < image.height; y += 2) {
        for (int x = 0; x < image.width; ++x) {
            const int sum = brightness(pixel(image, x, y)) + brightness(pixel(image, x, y + 1));
            text += letters[static_cast<std::size_t>(sum) * letters.size() / 511];
        }
        text += "\n";
    }
    return text;
}

}  // namespace shade16::host
