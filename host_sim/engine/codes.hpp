// Formats whose pixels are the colours that a target is about to round: Q24 codes with half a code added. What a grey or
// dithered target shows follows of them, so that its frames need no engine of their own here; tests hold both against
// each other.
#pragma once

#include <vector>

#include "shade16/shade16.hpp"

namespace shade16::host {

/// Of a grey format with so many bits.
template <int Bits>
struct UnroundedGray {
    using Pixel = ByChannel<Channels::luma, uint32_t>;
    static constexpr int luma_bits = Bits;
    static constexpr Pixel pack(uint32_t) { return {}; }
    static constexpr Pixel from_q24(uint32_t luma) { return {luma}; }
};

/// Of RGB565 where it is dithered, and so stepped exactly.
struct UnroundedExact565 {
    using Pixel = ByChannel<Channels::rgb, uint32_t>;
    static constexpr int red_bits = 5, green_bits = 6, blue_bits = 5;
    static constexpr Pixel pack(uint32_t, uint32_t, uint32_t) { return {}; }
    static constexpr Pixel from_q24(uint32_t r, uint32_t g, uint32_t b) { return {r, g, b}; }
};

template <PixelFormat Format>
struct UnroundedOf {
    using type = UnroundedExact565;
};
template <GrayFormat Format>
struct UnroundedOf<Format> {
    using type = UnroundedGray<Format::luma_bits>;
};

/// A frame's memory as the target has it, from its unrounded pixels.
template <PixelFormat Format>
std::vector<typename Format::Pixel> rounded_frame(const std::vector<ByChannel<channels_of_format<Format>, uint32_t>>& codes, Viewport viewport,
                                                  const Rgb& background) {
    const auto stride = static_cast<std::size_t>(pixels_a_row<Format>(viewport.width));
    std::vector<typename Format::Pixel> pixels(stride * static_cast<std::size_t>(viewport.height));
    clear_to(Band<Format>{pixels.data(), nullptr, viewport.width, 0, viewport.height}, background);  // also what is left of a row's last byte
    constexpr uint32_t to_bias = detail::q24_bias<Format>() - detail::q24_bias<Rgb888>();
    for (int32_t y = 0; y < viewport.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y), width = static_cast<std::size_t>(viewport.width);
        Place<Format> place(pixels.data() + row * stride, 0, y);
        for (std::size_t x = 0; x < width; ++x, ++place) {
            auto code = codes[row * width + x];
            for_each_channel<channels_of_format<Format>>([](uint32_t& c) { c += to_bias; }, code);
            detail::put<Format>(place, code);
        }
    }
    return pixels;
}

}  // namespace shade16::host
