// Every pixel as a square of pixels: a small display's frame, large enough to be looked at.
#pragma once

#include "host_sim/io/image.hpp"

namespace shade16::host {

/// Pixels of any number of bytes, each repeated so many times in both directions.
inline std::vector<uint8_t> magnified(const std::vector<uint8_t>& pixels, int width, int height, int times) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto pixel_bytes = static_cast<std::ptrdiff_t>(count == 0 ? 0 : pixels.size() / count);
    std::vector<uint8_t> result;
    result.reserve(pixels.size() * static_cast<std::size_t>(times * times));
    for (int y = 0; y < height; ++y) {
        std::vector<uint8_t> row;
        for (int x = 0; x < width; ++x) {
            const auto pixel = pixels.begin() + (std::ptrdiff_t{y} * width + x) * pixel_bytes;
            for (int i = 0; i < times; ++i) row.insert(row.end(), pixel, pixel + pixel_bytes);
        }
        for (int i = 0; i < times; ++i) result.insert(result.end(), row.begin(), row.end());
    }
    return result;
}

inline Image magnified(const Image& image, int times) {
    if (times == 1) return image;
    return {image.width * times, image.height * times, magnified(image.rgb, image.width, image.height, times),
            magnified(image.raw, image.width, image.height, times)};
}

}  // namespace shade16::host
