// Stage 4, set-up: one triangle on the screen, ready for the raster stage.
#pragma once

#include "shade16/pipeline/edge.hpp"
#include "shade16/pipeline/transform.hpp"
#include "shade16/target/band.hpp"

namespace shade16 {

/// The rows and columns whose centres a triangle may cover, half open.
struct PixelBox {
    int32_t left = 0, right = 0, top = 0, bottom = 0;

    constexpr bool is_empty() const { return left >= right || top >= bottom; }
};

/// A corner in raster coordinates: 1/16 pixel from the frame's top left.
struct RasterPoint {
    int32_t x, y;
};

/// One reciprocal a triangle, with the sign that slopes take from the side of the middle corner.
struct InverseArea {
    int32_t mantissa = 0;  // +-2^30 to +-2^31
    int32_t shift = 0;     // +-1 / area = mantissa * 2^(shift - 62)

    /// n / area * 2^exponent, saturated, to 30 bits whatever the size of n.
    constexpr int32_t times(int64_t n, int exponent) const {
        const int excess = 33 - leading_zeros(magnitude(n));  // brought to 31 bits first
        const int64_t shifted = excess > 0 ? n >> excess : static_cast<int64_t>(static_cast<uint64_t>(n) << min(-excess, 32));
        const int32_t high = mulhi(static_cast<int32_t>(shifted), mantissa);
        const int s = exponent + max(excess, -32) + shift - 30;
        if (s <= 0) return high >> min(-s, 31);
        return leading_zeros(magnitude(high)) > s ? shift_left(high, s) : (high < 0 ? INT32_MIN : INT32_MAX);
    }
    /// 1 / area times a channel's largest code, as the mantissa of max / 2^bits.
    SHADE16_INLINE constexpr InverseArea times_codes(int bits) const { return {mantissa - (mantissa >> bits), shift}; }
};

/// The corners from top to bottom, the edges from the first, and the sign and inverse of the doubled area.
template <PrecisionTier Tier>
struct TriangleSetup {
    const ScreenVertex<Tier>* corner[3]{};
    RasterPoint p[3]{};
    int32_t dx1 = 0, dy1 = 0, dx2 = 0, dy2 = 0;  // edges from the top corner to the middle and to the bottom one
    bool middle_is_right = false;
    int32_t reach_bits = 0;  // every edge is below 2^reach_bits
    InverseArea inverse{};
    uint64_t area = 0;

    /// From the top corner to the reference pixel: the centre of the first row in the corner's own column.
    constexpr RasterPoint to_reference() const { return {8 - (p[0].x & 15), (first_centre(p[0].y) << 4) + 8 - p[0].y}; }
    /// Edges below 2^13, 512 pixels: 32-bit products do.
    SHADE16_INLINE constexpr bool is_compact() const { return reach_bits <= 13; }
    /// Slopes change by more than any accumulator holds where the area is small against the edges.
    constexpr bool is_sliver() const { return area >> 1 <= uint64_t{1} << reach_bits; }

    /// Numerators of an attribute's slopes in x and y, times the signed area.
    SHADE16_INLINE constexpr int32_t slope_x(int32_t d1, int32_t d2) const { return d1 * dy2 - d2 * dy1; }
    SHADE16_INLINE constexpr int32_t slope_y(int32_t d1, int32_t d2) const { return d2 * dx1 - d1 * dx2; }
    constexpr int64_t long_slope_x(int32_t d1, int32_t d2) const { return multiply(d1, dy2) - multiply(d2, dy1); }
    constexpr int64_t long_slope_y(int32_t d1, int32_t d2) const { return multiply(d2, dx1) - multiply(d1, dx2); }
};

/// Twice the area in raster units, positive for triangles that run clockwise on the screen (y points down).
template <PrecisionTier Tier>
SHADE16_INLINE constexpr int64_t doubled_area(const ScreenVertex<Tier>& a, const ScreenVertex<Tier>& b, const ScreenVertex<Tier>& c) {
    const int32_t dx1 = int32_t{b.x} - a.x, dy1 = int32_t{b.y} - a.y, dx2 = int32_t{c.x} - a.x, dy2 = int32_t{c.y} - a.y;
#if SHADE16_NARROW_MULTIPLY
    const uint32_t reach = magnitude(dx1) | magnitude(dy1) | magnitude(dx2) | magnitude(dy2);
    if (reach < (uint32_t{1} << 15)) return dx1 * dy2 - dx2 * dy1;
#endif
    return multiply(dx1, dy2) - multiply(dx2, dy1);
}

template <PrecisionTier Tier>
SHADE16_INLINE constexpr PixelBox pixel_box(const ScreenVertex<Tier>& a, const ScreenVertex<Tier>& b, const ScreenVertex<Tier>& c, RasterPoint centre) {
    const int32_t left = min<int32_t>(a.x, min<int32_t>(b.x, c.x)), right = max<int32_t>(a.x, max<int32_t>(b.x, c.x));
    const int32_t top = min<int32_t>(a.y, min<int32_t>(b.y, c.y)), bottom = max<int32_t>(a.y, max<int32_t>(b.y, c.y));
    const int32_t x = centre.x + 7, y = centre.y + 7;  // first_centre, its addition done once
    return {(left + x) >> 4, (right + x) >> 4, (top + y) >> 4, (bottom + y) >> 4};
}

/// A triangle that faces the camera, placed in a band.
template <PrecisionTier Tier>
struct FacingTriangle {
    const ScreenVertex<Tier>*a, *b, *c;  // counter-clockwise in the world, so clockwise where y points down
    RasterPoint centre;                  // of the frame
    PixelBox whole;
    int32_t first_row, end_row;  // the part in the band

    SHADE16_INLINE constexpr FacingTriangle(const ScreenVertex<Tier>& a_, const ScreenVertex<Tier>& b_, const ScreenVertex<Tier>& c_, RasterPoint frame_centre,
                                            int32_t first_band_row, int32_t band_rows)
        : a(&a_), b(&b_), c(&c_), centre(frame_centre), whole(pixel_box(a_, b_, c_, frame_centre)), first_row(max(whole.top, first_band_row)),
          end_row(min(whole.bottom, first_band_row + band_rows)) {}

    SHADE16_INLINE constexpr bool shows(int32_t frame_width) const {
        return first_row < end_row && whole.left < whole.right && whole.right > 0 && whole.left < frame_width;
    }
    constexpr PixelBox box(int32_t frame_width) const { return {max(whole.left, int32_t{0}), min(whole.right, frame_width), first_row, end_row}; }
};

/// Error: 2^-28 relative.
SHADE16_INLINE constexpr InverseArea inverse_of(uint64_t area) {
    if (area >> 32 == 0) {
        const int shift = leading_zeros(static_cast<uint32_t>(area));
        return {static_cast<int32_t>(reciprocal_of_normalized(static_cast<uint32_t>(area) << shift) >> 1), shift};
    }
    const Scaled normalized = Scaled::normalized(area, 0);
    return {static_cast<int32_t>(reciprocal_of_normalized(normalized.mantissa) >> 1), 32 - normalized.exponent};
}

/// Sorts the corners by y and divides once.
template <PrecisionTier Tier>
constexpr TriangleSetup<Tier> set_up(const FacingTriangle<Tier>& facing) {
    TriangleSetup<Tier> t;
    const ScreenVertex<Tier>*top = facing.a, *middle = facing.b, *bottom = facing.c;
    bool runs_clockwise = false;  // the corners as given run counter-clockwise; every exchange turns that round
    const auto order = [&](auto& upper, auto& lower) {
        if (lower->y >= upper->y) return;
        const auto* exchanged = upper;
        upper = lower, lower = exchanged;
        runs_clockwise = !runs_clockwise;
    };
    order(top, middle);
    order(top, bottom);
    order(middle, bottom);
    t.corner[0] = top, t.corner[1] = middle, t.corner[2] = bottom;
    for (int i = 0; i < 3; ++i) t.p[i] = {t.corner[i]->x + facing.centre.x, t.corner[i]->y + facing.centre.y};
    t.dx1 = t.p[1].x - t.p[0].x, t.dy1 = t.p[1].y - t.p[0].y;
    t.dx2 = t.p[2].x - t.p[0].x, t.dy2 = t.p[2].y - t.p[0].y;
    t.middle_is_right = runs_clockwise;
    t.reach_bits = 32 - leading_zeros(magnitude(t.dx1) | magnitude(t.dy1) | magnitude(t.dx2) | magnitude(t.dy2));
    t.area = static_cast<uint64_t>(-doubled_area(*facing.a, *facing.b, *facing.c));
    t.inverse = inverse_of(t.area);
    if (!t.middle_is_right) t.inverse.mantissa = -t.inverse.mantissa;
    return t;
}

}  // namespace shade16
