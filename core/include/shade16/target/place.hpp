// Where painters write: a pointer to the pixel; or, where pixels share bytes or depend on where they stand, a place.
#pragma once

#include "shade16/target/dither.hpp"

namespace shade16 {

/// Whether a pixel's place must be known to write it.
template <PixelFormat Format>
inline constexpr bool is_placed = pixels_a_byte_log2<Format> != 0 || DitheredFormat<Format>;

namespace detail {
template <PixelFormat Format>
inline constexpr bool takes_fractions = [] {
    if constexpr (GrayFormat<Format>) return requires(uint32_t c) { Format::from_q24(c); };
    else return requires(uint32_t c) { Format::from_q24(c, c, c); };
}();

/// Q24 codes as a pixel. A format may take the fractions too: that is how the tests look behind the rounding.
template <PixelFormat Format, class... Code>
SHADE16_INLINE constexpr typename Format::Pixel pixel_from_q24(Code... code) {
    if constexpr (takes_fractions<Format>) return Format::from_q24(code...);
    else return Format::pack((code >> 24)...);
}
}  // namespace detail

/// A pixel of a row, by its column.
template <PixelFormat Format>
class Place {
public:
    constexpr Place(typename Format::Pixel* row, int32_t x, int32_t y) : row_(row), x_(x) {
        if constexpr (DitheredFormat<Format>) thresholds_ = Format::matrix.thresholds[y & 7];
    }
    SHADE16_INLINE constexpr Place& operator++() {
        ++x_;
        return *this;
    }
    SHADE16_INLINE friend constexpr Place operator+(Place p, int32_t columns) {
        p.x_ += columns;
        return p;
    }
    SHADE16_INLINE friend constexpr Place opaque(Place p) { return p; }
    constexpr int32_t column() const { return x_; }
    /// Colours in Q24 codes with detail::q24_bias added.
    template <class... Code>
    SHADE16_INLINE constexpr void put(Code... q24) const {
        uint32_t threshold = 0;
        if constexpr (DitheredFormat<Format>) threshold = uint32_t{thresholds_[x_ & 7]} << (24 - detail::threshold_bits<Format>);
        store(detail::pixel_from_q24<Format>((q24 + threshold)...));
    }

private:
    SHADE16_INLINE constexpr void store(typename Format::Pixel pixel) const {
        constexpr int log2 = pixels_a_byte_log2<Format>;
        if constexpr (log2 == 0) {
            row_[x_] = pixel;
        } else if constexpr (log2 == 1) {  // two cases are quicker than a mask that is shifted
            uint8_t& byte = row_[x_ >> 1];
            byte = static_cast<uint8_t>((x_ & 1) != 0 ? (byte & 0xF0) | pixel : (byte & 0x0F) | pixel << 4);
        } else {
            constexpr int32_t last = (int32_t{1} << log2) - 1;
            constexpr int bits_log2 = 3 - log2;
            constexpr unsigned mask = (1u << (1 << bits_log2)) - 1;
            const int shift = static_cast<int>(last - (x_ & last)) << bits_log2;
            uint8_t& byte = row_[x_ >> log2];
            byte = static_cast<uint8_t>((byte & ~(mask << shift)) | static_cast<unsigned>(pixel) << shift);
        }
    }

    typename Format::Pixel* row_;
    int32_t x_;
    const uint8_t* thresholds_ = nullptr;
};

/// The code of a grey pixel in a row of memory: what Place wrote.
template <GrayFormat Format>
constexpr uint32_t luma_code(const typename Format::Pixel* row, int32_t x) {
    constexpr int log2 = pixels_a_byte_log2<Format>;
    constexpr int32_t last = (int32_t{1} << log2) - 1;
    const int shift = static_cast<int>(last - (x & last)) << (3 - log2);
    return (uint32_t{row[x >> log2]} >> shift) & ((uint32_t{1} << Format::luma_bits) - 1);
}

namespace detail {
template <PixelFormat Format>
SHADE16_INLINE constexpr void put(typename Format::Pixel* pixel, const ByChannel<channels_of_format<Format>, uint32_t>& q24) {
    if constexpr (GrayFormat<Format>) *pixel = pixel_from_q24<Format>(q24.luma);
    else *pixel = pixel_from_q24<Format>(q24.r, q24.g, q24.b);
}
template <PixelFormat Format>
SHADE16_INLINE constexpr void put(const Place<Format>& pixel, const ByChannel<channels_of_format<Format>, uint32_t>& q24) {
    if constexpr (GrayFormat<Format>) pixel.put(q24.luma);
    else pixel.put(q24.r, q24.g, q24.b);
}

/// The number of bits of each channel.
template <PixelFormat Format>
constexpr ByChannel<channels_of_format<Format>, int> channel_bits() {
    if constexpr (GrayFormat<Format>) return {Format::luma_bits};
    else return {Format::red_bits, Format::green_bits, Format::blue_bits};
}
}  // namespace detail

}  // namespace shade16
