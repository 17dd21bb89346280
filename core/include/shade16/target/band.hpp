// Band: some full rows of the frame, what fits in RAM and goes to the display in one transfer. A framebuffer is the band
// of all rows.
#pragma once

#include "shade16/num/accumulator.hpp"
#include "shade16/target/gray.hpp"
#include "shade16/target/place.hpp"

namespace shade16 {

inline constexpr int32_t max_target_px = 2048;

/// How many Pixels of memory a row takes: rows begin on a byte.
template <PixelFormat Format>
SHADE16_INLINE constexpr int32_t pixels_a_row(int32_t width) {
    constexpr int log2 = pixels_a_byte_log2<Format>;
    return (width + (int32_t{1} << log2) - 1) >> log2;
}

/// Rows [first_row, first_row + rows) of a frame `width` wide. The memory is the caller's.
template <PixelFormat Format>
struct Band {
    typename Format::Pixel* pixels = nullptr;  // pixels_a_row a row; what is left of a row's last byte holds the background
    uint16_t* depth = nullptr;  // one a pixel of the frame; nullptr where the scene needs no depth
    int32_t width = 0;
    int32_t first_row = 0;
    int32_t rows = 0;

    constexpr typename Format::Pixel* row(int32_t y) const { return pixels + (y - first_row) * pixels_a_row<Format>(width); }
    constexpr size_t pixel_bytes() const { return static_cast<size_t>(pixels_a_row<Format>(width) * rows) * sizeof(*pixels); }
    constexpr uint16_t* depth_row(int32_t y) const { return depth + (y - first_row) * width; }
};

inline constexpr uint16_t far_depth = 65535;

/// The pixel nearest to a colour.
template <ColorFormat Format>
constexpr typename Format::Pixel nearest_pixel(Rgb color) {
    // round(raw * max / 65535), halves down: the quotient by 65535 is exact as a sum of shifts below 2^32.
    const auto code = [](Unorm16 c, int bits) {
        const uint32_t x = uint32_t{c.raw} * ((uint32_t{1} << bits) - 1) + 32767;
        return (x + (x >> 16) + 1) >> 16;
    };
    return Format::pack(code(color.r, Format::red_bits), code(color.g, Format::green_bits), code(color.b, Format::blue_bits));
}

namespace detail {
using FourHalfwords [[gnu::may_alias]] = uint64_t;
using Halfword [[gnu::may_alias]] = uint16_t;

/// Four halfwords a store and sixteen stores a turn; `first` may be at any even address.
inline void fill_halfwords(uint16_t* first, int32_t count, uint16_t value) {
    for (; (reinterpret_cast<uintptr_t>(first) & 7) != 0 && count > 0; --count) *first++ = value;
    const uint64_t four = value * uint64_t{0x0001000100010001};
    auto* wide = reinterpret_cast<FourHalfwords*>(first);
    for (; count >= 64; count -= 64, wide += 16) {
        wide[0] = four, wide[1] = four, wide[2] = four, wide[3] = four;
        wide[4] = four, wide[5] = four, wide[6] = four, wide[7] = four;
        wide[8] = four, wide[9] = four, wide[10] = four, wide[11] = four;
        wide[12] = four, wide[13] = four, wide[14] = four, wide[15] = four;
    }
    for (first = reinterpret_cast<uint16_t*>(wide); count > 0; --count) *first++ = value;
}

/// The same for bytes.
inline void fill_bytes(uint8_t* first, int32_t count, uint8_t value) {
    for (; (reinterpret_cast<uintptr_t>(first) & 1) != 0 && count > 0; --count) *first++ = value;
    fill_halfwords(reinterpret_cast<Halfword*>(first), count >> 1, static_cast<uint16_t>(value * 0x0101u));
    if ((count & 1) != 0) first[count - 1] = value;
}

template <class T>
constexpr void fill(T* first, int32_t count, T value) {
    for (; count > 0; --count) *first++ = value;
}
constexpr void fill(uint16_t* first, int32_t count, uint16_t value) {
    if (!__builtin_is_constant_evaluated()) return fill_halfwords(first, count, value);
    for (; count > 0; --count) *first++ = value;
}
constexpr void fill(uint8_t* first, int32_t count, uint8_t value) {
    if (!__builtin_is_constant_evaluated()) return fill_bytes(first, count, value);
    for (; count > 0; --count) *first++ = value;
}
}  // namespace detail

template <PixelFormat Format>
constexpr void clear(const Band<Format>& band, typename Format::Pixel background) {
    detail::fill(band.pixels, pixels_a_row<Format>(band.width) * band.rows, background);
    if (band.depth != nullptr) detail::fill(band.depth, band.width * band.rows, far_depth);
}

namespace detail {
/// A row in one colour, or rows that are alike, from a pattern of eight pixels.
template <PixelFormat Format>
constexpr void fill_rows(typename Format::Pixel* row, int32_t end, int32_t y, const ByChannel<channels_of_format<Format>, uint32_t>& q24) {
    constexpr int count = 8 >> pixels_a_byte_log2<Format>;
    typename Format::Pixel pattern[static_cast<size_t>(count)]{};
    for (Place<Format> place(pattern, 0, y); place.column() < 8; ++place) put<Format>(place, q24);
    if constexpr (count == 1 || !DitheredFormat<Format>) return fill(row, end, pattern[0]);
    for (; end >= count; end -= count, row += count)
#pragma GCC unroll 8
        for (int k = 0; k < count; ++k) row[k] = pattern[k];
    for (int k = 0; k < count && k < end; ++k) row[k] = pattern[k];
}
}  // namespace detail

/// Fills a band with a colour as the painters would.
template <PixelFormat Format>
constexpr void clear_to(const Band<Format>& band, const Rgb& background) {
    if constexpr (ColorFormat<Format> && !is_placed<Format> && !detail::takes_fractions<Format>) {
        clear(band, nearest_pixel<Format>(background));
    } else {
        constexpr Channels channels = channels_of_format<Format>;
        const auto bits = detail::channel_bits<Format>();
        const AccumulatorOf<channels> color = as_accumulator<channels>(background);
        ByChannel<channels, uint32_t> q24;
        for_each_channel<channels>([](uint32_t& code, uint32_t c, int b) { code = c * ((uint32_t{1} << b) - 1) + detail::q24_bias<Format>(); }, q24, color, bits);
        // Without dithering all rows are alike, and the band is filled as one.
        const int32_t rows_at_once = DitheredFormat<Format> ? 1 : band.rows;
        for (int32_t y = 0; y < band.rows; y += rows_at_once)
            detail::fill_rows<Format>(band.row(band.first_row + y), pixels_a_row<Format>(band.width) * rows_at_once, band.first_row + y, q24);
        if (band.depth != nullptr) detail::fill(band.depth, band.width * band.rows, far_depth);
    }
}

/// A band with memory of its own.
template <PixelFormat PixelLayout, int32_t Width, int32_t Rows, bool Depth = true>
struct BandBuffer {
    using Format = PixelLayout;
    static constexpr int32_t rows = Rows;
    static_assert(Width > 0 && Rows > 0 && Width <= max_target_px && Rows <= max_target_px, "a target is 1 to 2048 pixels wide and high");
    static constexpr size_t count = static_cast<size_t>(Width) * static_cast<size_t>(Rows);
    typename Format::Pixel pixels[static_cast<size_t>(pixels_a_row<Format>(Width)) * static_cast<size_t>(Rows)]{};
    uint16_t depth[Depth ? count : 1]{};

    constexpr Band<Format> band(int32_t first_row = 0, int32_t row_count = Rows) {
        return {pixels, Depth ? depth : nullptr, Width, first_row, row_count};
    }
};

/// A whole frame with memory of its own.
template <PixelFormat Format, int32_t Width, int32_t Height, bool Depth = true>
using Framebuffer = BandBuffer<Format, Width, Height, Depth>;

}  // namespace shade16
