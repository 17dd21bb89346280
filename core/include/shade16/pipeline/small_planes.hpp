// Colours and depth of small triangles: slopes in 32-bit numbers of one scale.
#pragma once

#include "shade16/pipeline/paint_packed.hpp"

namespace shade16::detail {

/// What turns an attribute's differences along two edges into its slopes. Edges are lifted to use their bits: to below
/// 2^14, so that a difference of 2^16 fits. `right` is at least 2.
struct SmallGradient {
    int32_t dx1, dy1, dx2, dy2;
    int32_t inverse;  // 1 / area = inverse * 2^(shift - 62)
    int right;        // brings a product's high word to Q16 codes of five bits

    /// Edges are at most `area` < 2^(32 - shift).
    SHADE16_INLINE constexpr SmallGradient(RasterPoint edge1, RasterPoint edge2, uint32_t area) {
        const int shift = leading_zeros(area), lift = max(shift - 18, 4);
        dx1 = shift_left(edge1.x, lift), dy1 = shift_left(edge1.y, lift);
        dx2 = shift_left(edge2.x, lift), dy2 = shift_left(edge2.y, lift);
        inverse = static_cast<int32_t>(reciprocal_of_normalized(area << shift) >> 1);
        right = 20 + lift - shift;
    }
    SHADE16_INLINE constexpr int32_t x(int32_t d1, int32_t d2) const { return d2 * dy1 - d1 * dy2; }
    SHADE16_INLINE constexpr int32_t y(int32_t d1, int32_t d2) const { return d1 * dx2 - d2 * dx1; }
};

/// Depth at the middle pixel and its steps. False where a step is too steep for 32 bits.
SHADE16_INLINE constexpr bool set_small_depth(const SmallGradient& gradient, int32_t a, int32_t b, int32_t c, RasterPoint p, uint32_t& z, uint32_t& z_x,
                                              uint32_t& z_y) {
    const int32_t d1 = b - a, d2 = c - a;
    const int32_t x = mulhi(gradient.x(d1, d2), gradient.inverse), y = mulhi(gradient.y(d1, d2), gradient.inverse);
    if (((x ^ x >> 31) | (y ^ y >> 31)) >> 22 != 0) return false;
    const int32_t step_x = shift_left(x, 8) >> (gradient.right - 2), step_y = shift_left(y, 8) >> (gradient.right - 2);
    z_x = static_cast<uint32_t>(step_x), z_y = static_cast<uint32_t>(step_y);
    z = (static_cast<uint32_t>(a) << 16) - static_cast<uint32_t>(step_x >> 4) * static_cast<uint32_t>(p.x) -
        static_cast<uint32_t>(step_y >> 4) * static_cast<uint32_t>(p.y);
    return true;
}

/// One channel in Q16 codes: at the middle pixel, and its slopes a sub-pixel.
struct SmallChannel {
    int32_t value, x, y;

    template <class Channel>
    SHADE16_INLINE constexpr SmallChannel(const SmallGradient& gradient, int32_t inverse, int right, int32_t max_code, Channel a, Channel b, Channel c,
                                          RasterPoint p) {
        constexpr int down = sizeof(Channel) == 2 ? 0 : 9;  // to Q15
        const int32_t c0 = static_cast<int32_t>(a >> down);
        const int32_t d1 = static_cast<int32_t>(b >> down) - c0, d2 = static_cast<int32_t>(c >> down) - c0;
        x = mulhi(gradient.x(d1, d2), inverse) >> right, y = mulhi(gradient.y(d1, d2), inverse) >> right;
        const uint32_t way = static_cast<uint32_t>(x) * static_cast<uint32_t>(p.x) + static_cast<uint32_t>(y) * static_cast<uint32_t>(p.y);
        value = c0 * max_code * 2 - static_cast<int32_t>(way);
    }
};

/// A small triangle's colours and depth at the pixel in the middle of its box, and their slopes.
template <bool Depth>
struct SmallPlanes {
    uint32_t word, word_x, word_y;
    uint32_t z, z_x, z_y;

    /// Corners with their places from the middle pixel. False where the triangle is too thin or its depth too steep.
    template <PrecisionTier Tier>
    SHADE16_INLINE constexpr bool set(const ScreenVertex<Tier>& a, const ScreenVertex<Tier>& b, const ScreenVertex<Tier>& c, RasterPoint p, RasterPoint q,
                                      RasterPoint r, int32_t extent_px) {
        const RasterPoint edge1{q.x - p.x, q.y - p.y}, edge2{r.x - p.x, r.y - p.y};
        const int32_t area = edge2.x * edge1.y - edge1.x * edge2.y;
        if (area < (extent_px + 2) * 16) return false;
        const SmallGradient gradient(edge1, edge2, static_cast<uint32_t>(area));
        if constexpr (Depth)
            if (!set_small_depth(gradient, a.z, b.z, c.z, p, z, z_x, z_y)) return false;
        const int32_t five = gradient.inverse - (gradient.inverse >> 5), six = gradient.inverse - (gradient.inverse >> 6);
        const SmallChannel green(gradient, six, gradient.right + 3, 63, a.g, b.g, c.g, p);
        const SmallChannel red(gradient, five, gradient.right + 4, 31, a.r, b.r, c.r, p);
        const SmallChannel blue(gradient, five, gradient.right + 4, 31, a.b, b.b, c.b, p);
        constexpr uint32_t half_a_code = join_fields(16, 16, 16);
        word = join_fields(red.value >> 11, green.value >> 11, blue.value >> 11) + half_a_code;
        word_x = join_fields((red.x + 64) >> 7, (green.x + 64) >> 7, (blue.x + 64) >> 7);
        word_y = join_fields((red.y + 64) >> 7, (green.y + 64) >> 7, (blue.y + 64) >> 7);
        return true;
    }
};

}  // namespace shade16::detail
