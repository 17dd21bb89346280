// Pixel formats: how a colour lies in memory.
#pragma once

#include "shade16/num/channels.hpp"

namespace shade16 {

/// A format of three channels. Codes are 0 to 2^bits - 1 a channel.
template <class F>
concept ColorFormat = requires(uint32_t r, uint32_t g, uint32_t b) {
    typename F::Pixel;
    F::red_bits + F::green_bits + F::blue_bits;
    F::pack(r, g, b);
};

/// A format of one channel, which a pipeline of Channels::luma draws.
template <class F>
concept GrayFormat = requires(uint32_t luma) {
    typename F::Pixel;
    F::luma_bits;
    F::pack(luma);
};

/// What the raster stage asks of a format. `Pixel` is what its memory is made of; a byte of several pixels has
/// `pixels_a_byte_log2`, and its leftmost pixel in the highest bits.
template <class F>
concept PixelFormat = ColorFormat<F> || GrayFormat<F>;

template <PixelFormat F>
inline constexpr Channels channels_of_format = GrayFormat<F> ? Channels::luma : Channels::rgb;

/// 0 where a `Pixel` is one pixel.
template <PixelFormat F>
inline constexpr int pixels_a_byte_log2 = [] {
    if constexpr (requires { F::pixels_a_byte_log2; }) return F::pixels_a_byte_log2;
    else return 0;
}();

/// A format whose three channels step in one 32-bit word, laid out [green 6.5 | red 5.6 | blue 5.5].
template <class F>
concept PackedFormat = PixelFormat<F> && requires(uint32_t word) { F::from_word(word); };

/// 16 bits a pixel in the machine's byte order: what LVGL, DMA2D and Linux framebuffers take.
struct Rgb565 {
    using Pixel = uint16_t;
    static constexpr const char* name = "rgb565";
    static constexpr int red_bits = 5, green_bits = 6, blue_bits = 5;
    static constexpr Pixel pack(uint32_t r, uint32_t g, uint32_t b) { return static_cast<Pixel>(r << 11 | g << 5 | b); }
    static constexpr Pixel from_rgb565(uint16_t code) { return code; }
    SHADE16_INLINE static constexpr Pixel from_word(uint32_t word) {
        const uint32_t codes = (word >> 5) & 0x07E0F81F;
        return static_cast<Pixel>(codes | codes >> 16);
    }
};

/// The same with the bytes exchanged: the order in which SPI displays take them.
struct Rgb565Swapped {
    using Pixel = uint16_t;
    static constexpr const char* name = "rgb565_swapped";
    static constexpr int red_bits = 5, green_bits = 6, blue_bits = 5;
    SHADE16_INLINE static constexpr Pixel swapped(Pixel p) { return static_cast<Pixel>(p << 8 | p >> 8); }
    static constexpr Pixel pack(uint32_t r, uint32_t g, uint32_t b) { return swapped(Rgb565::pack(r, g, b)); }
    static constexpr Pixel from_rgb565(uint16_t code) { return swapped(code); }
    SHADE16_INLINE static constexpr Pixel from_word(uint32_t word) { return swapped(Rgb565::from_word(word)); }
};

/// Three bytes a pixel, red first.
struct Rgb888 {
    struct Pixel {
        uint8_t r = 0, g = 0, b = 0;
        friend constexpr bool operator==(Pixel, Pixel) = default;
    };
    static constexpr const char* name = "rgb888";
    static constexpr int red_bits = 8, green_bits = 8, blue_bits = 8;
    static constexpr Pixel pack(uint32_t r, uint32_t g, uint32_t b) {
        return {static_cast<uint8_t>(r), static_cast<uint8_t>(g), static_cast<uint8_t>(b)};
    }
};

}  // namespace shade16
