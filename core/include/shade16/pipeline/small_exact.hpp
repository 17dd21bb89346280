// Small triangles on targets that step by the policy `exact`: each channel in a word of its own, as Q24 codes.
#pragma once

#include "shade16/pipeline/paint_exact.hpp"
#include "shade16/pipeline/small_planes.hpp"

namespace shade16 {

/// Farthest from exact interpolation before rounding, in codes of the target: at most 28 steps of a unit of `mulhi`, which is
/// 2^-15 code in 8 bits and finer in fewer. Well inside the bound of the policy `exact`.
inline constexpr uint32_t small_exact_max_error_per_65536_code = 32;

}  // namespace shade16

namespace shade16::detail {

/// One channel in Q24 codes: at the middle pixel, and its steps. From Q15 channels.
/// Error   small_exact_max_error.
struct SmallExactChannel {
    uint32_t value = 0, x = 0, y = 0;

    /// False where a step is too steep for 32 bits.
    template <PixelFormat Format, class Channel>
    SHADE16_INLINE constexpr bool set(const SmallGradient& gradient, int bits, Channel a, Channel b, Channel c, RasterPoint p) {
        static_assert(sizeof(Channel) == 2, "small triangles with exact steps have channels of 16 bits");
        const int32_t c0 = a, d1 = b - c0, d2 = c - c0;
        const int32_t inverse = gradient.inverse - (gradient.inverse >> bits);
        const int right = gradient.right + 9 - bits;  // at least 3
        const int32_t fine_x = mulhi(gradient.x(d1, d2), inverse), fine_y = mulhi(gradient.y(d1, d2), inverse);
        if (((fine_x ^ fine_x >> 31) | (fine_y ^ fine_y >> 31)) >> min(18 + right, 31) != 0) return false;
        const int32_t step_x = right < 12 ? shift_left(fine_x, 12 - right) : fine_x >> (right - 12);
        const int32_t step_y = right < 12 ? shift_left(fine_y, 12 - right) : fine_y >> (right - 12);
        x = static_cast<uint32_t>(step_x), y = static_cast<uint32_t>(step_y);
        value = (static_cast<uint32_t>(c0) * ((uint32_t{1} << bits) - 1) << 9) + q24_bias<Format>() -
                static_cast<uint32_t>(step_x >> 4) * static_cast<uint32_t>(p.x) - static_cast<uint32_t>(step_y >> 4) * static_cast<uint32_t>(p.y);
        return true;
    }
};

/// As SmallPlanes; and where the middle pixel stands in the frame.
template <PixelFormat Format, bool Depth>
struct SmallExactPlanes {
    static constexpr Channels channels = channels_of_format<Format>;
    ByChannel<channels, SmallExactChannel> color;
    uint32_t z = 0, z_x = 0, z_y = 0;
    int32_t column = 0, row = 0;  // of the middle pixel in the frame
    int32_t first_row = 0;        // of the band

    template <PrecisionTier Tier>
    SHADE16_INLINE constexpr bool set(const ScreenVertex<Tier>& a, const ScreenVertex<Tier>& b, const ScreenVertex<Tier>& c, RasterPoint p, RasterPoint q,
                                      RasterPoint r, int32_t extent_px) {
        const RasterPoint edge1{q.x - p.x, q.y - p.y}, edge2{r.x - p.x, r.y - p.y};
        const int32_t area = edge2.x * edge1.y - edge1.x * edge2.y;
        if (area < (extent_px + 2) * 16) return false;
        const SmallGradient gradient(edge1, edge2, static_cast<uint32_t>(area));
        if constexpr (Depth)
            if (!set_small_depth(gradient, a.z, b.z, c.z, p, z, z_x, z_y)) return false;
        bool fits = true;
        const auto bits = channel_bits<Format>();
        for_each_channel<channels>([&](auto& channel, int n, auto at_a, auto at_b, auto at_c) { fits = fits && channel.template set<Format>(gradient, n, at_a, at_b, at_c, p); },
                                   color, bits, a, b, c);
        return fits;
    }
    /// The codes at a pixel counted from the middle one.
    SHADE16_INLINE constexpr ByChannel<channels, uint32_t> at(uint32_t x, uint32_t y) const {
        ByChannel<channels, uint32_t> q24;
        for_each_channel<channels>([&](uint32_t& code, const SmallExactChannel& c) { code = c.value + c.y * y + c.x * x; }, q24, color);
        return q24;
    }
    SHADE16_INLINE constexpr void next_pixel(ByChannel<channels, uint32_t>& q24) const {
        for_each_channel<channels>([](uint32_t& code, const SmallExactChannel& c) { code += c.x; }, q24, color);
    }
};

/// `count` pixels from `pixel` on, in both arrays by one index, which counts up to 0.
template <PixelFormat Format, bool Depth, class Pixel>
SHADE16_INLINE constexpr void small_exact_span(const SmallExactPlanes<Format, Depth>& planes, Pixel pixel, uint16_t* stored, int32_t count, uint32_t x,
                                               uint32_t y) {
    auto color = planes.at(x, y);
    const uint32_t z_x = Depth ? planes.z_x : 0;
    uint32_t z = Depth ? planes.z + planes.z_y * y + z_x * x : 0;
    const Pixel end = opaque(pixel + count);
    uint16_t* const depth_end = Depth ? opaque(stored + count) : nullptr;
    int32_t i = -count;
    do {
        if (!Depth || nearer<true>(depth_end + i, z)) put<Format>(end + i, color);
        planes.next_pixel(color);
        if constexpr (Depth) z += z_x;
        i = opaque(i) + 1;
    } while (i != 0);
}

}  // namespace shade16::detail
