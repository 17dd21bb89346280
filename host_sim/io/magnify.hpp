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

/// Pixels of fewer bits than a byte has, the leftmost in the highest bits: a byte each, and back.
inline std::vector<uint8_t> apart(const std::vector<uint8_t>& bytes, int width, int height, int bits) {
    const int per_byte = 8 / bits, stride = (width + per_byte - 1) / per_byte;
    std::vector<uint8_t> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const uint8_t byte = bytes[static_cast<std::size_t>(y * stride + x / per_byte)];
            pixels.push_back(static_cast<uint8_t>((byte >> (8 - bits - x % per_byte * bits)) & ((1 << bits) - 1)));
        }
    return pixels;
}
inline std::vector<uint8_t> together(const std::vector<uint8_t>& pixels, int width, int height, int bits) {
    const int per_byte = 8 / bits, stride = (width + per_byte - 1) / per_byte;
    std::vector<uint8_t> bytes(static_cast<std::size_t>(stride) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            uint8_t& byte = bytes[static_cast<std::size_t>(y * stride + x / per_byte)];
            byte = static_cast<uint8_t>(byte | pixels[static_cast<std::size_t>(y * width + x)] << (8 - bits - x % per_byte * bits));
        }
    return bytes;
}

inline Image magnified(const Image& image, int times) {
    if (times == 1) return image;
    const int width = image.width * times, height = image.height * times;
    const bool is_packed = image.raw_bits != 0 && image.raw_bits < 8;
    const auto raw = is_packed ? together(magnified(apart(image.raw, image.width, image.height, image.raw_bits), image.width, image.height, times),
                                          width, height, image.raw_bits)
                               : magnified(image.raw, image.width, image.height, times);
    return {width, height, magnified(image.rgb, image.width, image.height, times), raw, image.raw_bits};
}

}  // namespace shade16::host
