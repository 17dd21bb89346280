// Colour stepping, policy `exact`: one accumulator a channel, in codes with 24 fraction bits. Also what formats use that
// do not pack into one word.
#pragma once

#include "shade16/pipeline/depth.hpp"

namespace shade16 {

/// Farthest from exact interpolation before rounding, in codes of the target, over 2048 pixels.
inline constexpr uint32_t exact_stepping_max_error_per_1024_code = 2;

/// One channel over a triangle, in Q24 codes.
struct ExactPlane {
    uint32_t value = 0;
    int32_t step_x = 0, step_y = 0;

    template <PrecisionTier Tier>
    constexpr ExactPlane(const TriangleSetup<Tier>& t, typename ScreenVertex<Tier>::Channel ScreenVertex<Tier>::*channel, int bits,
                         RasterPoint from_corner) {
        constexpr int channel_bits = ScreenVertex<Tier>::channel_bits;
        const uint32_t max_code = (uint32_t{1} << bits) - 1;
        const auto at = [&](int i) { return static_cast<int32_t>(t.corner[i]->*channel); };
        const int32_t c0 = at(0), d1 = at(1) - c0, d2 = at(2) - c0;
        value = (static_cast<uint32_t>(c0) * max_code << (24 - channel_bits)) + (uint32_t{1} << 23);
        const InverseArea inverse = t.inverse.times_codes(bits);
        step_x = inverse.times(t.long_slope_x(d1, d2), bits + 28 - channel_bits);
        step_y = inverse.times(t.long_slope_y(d1, d2), bits + 28 - channel_bits);
        value += static_cast<uint32_t>((multiply(step_x, from_corner.x) + multiply(step_y, from_corner.y)) >> 4);
    }
    constexpr bool is_steep() const { return (magnitude(step_x) | magnitude(step_y)) >= (uint32_t{1} << 30); }
    SHADE16_INLINE constexpr uint32_t at(int32_t column) const {
        return value + static_cast<uint32_t>(step_x) * static_cast<uint32_t>(column);
    }
    constexpr void skip_rows(int32_t rows) { value += static_cast<uint32_t>(step_y) * static_cast<uint32_t>(rows); }
};

namespace detail {
/// Q24 codes as a pixel. A format may take the fractions too: that is how the tests look behind the rounding.
template <PixelFormat Format>
SHADE16_INLINE constexpr typename Format::Pixel pixel_from_q24(uint32_t r, uint32_t g, uint32_t b) {
    if constexpr (requires { Format::from_q24(r, g, b); }) return Format::from_q24(r, g, b);
    else return Format::pack(r >> 24, g >> 24, b >> 24);
}
/// A pixel's own light, saturated and rounded.
template <PixelFormat Format>
SHADE16_INLINE constexpr typename Format::Pixel pixel_of_light(const Accumulator& sum) {
    const auto code = [](uint32_t c, int bits) { return min(c, Accumulator::one) * ((uint32_t{1} << bits) - 1) + (uint32_t{1} << 23); };
    return pixel_from_q24<Format>(code(sum.r, Format::red_bits), code(sum.g, Format::green_bits), code(sum.b, Format::blue_bits));
}
}  // namespace detail

template <PixelFormat Format, bool Depth>
class ExactPainter {
public:
    template <PrecisionTier Tier>
    constexpr ExactPainter(const TriangleSetup<Tier>& t, const DepthPlane& depth, RasterPoint from_corner)
        : r_(t, &ScreenVertex<Tier>::r, Format::red_bits, from_corner),
          g_(t, &ScreenVertex<Tier>::g, Format::green_bits, from_corner),
          b_(t, &ScreenVertex<Tier>::b, Format::blue_bits, from_corner), depth_(depth) {}

    constexpr bool is_steep() const { return r_.is_steep() || g_.is_steep() || b_.is_steep(); }
    constexpr void skip_rows(int32_t rows) {
        r_.skip_rows(rows), g_.skip_rows(rows), b_.skip_rows(rows);
        depth_.skip_rows(rows);
    }
    SHADE16_INLINE constexpr void next_row() { skip_rows(1); }
    SHADE16_INLINE constexpr void span(typename Format::Pixel* pixel, uint16_t* stored, int32_t column, int32_t count) const {
        uint32_t r = r_.at(column), g = g_.at(column), b = b_.at(column), z = depth_.at(column);
        for (; count > 0; --count, ++pixel) {
            if (nearer<Depth>(stored, z)) *pixel = detail::pixel_from_q24<Format>(r, g, b);
            r += static_cast<uint32_t>(r_.step_x), g += static_cast<uint32_t>(g_.step_x), b += static_cast<uint32_t>(b_.step_x);
            z += static_cast<uint32_t>(depth_.step_x);
            if constexpr (Depth) ++stored;
        }
    }

private:
    ExactPlane r_, g_, b_;
    DepthPlane depth_;
};

/// Barycentric coordinates of the second and third corner as Q30, each in [0, 1]; together they may exceed 1 by rounding.
struct BarycentricWeights {
    int32_t b = 0, c = 0;
    constexpr uint32_t a() const { return static_cast<uint32_t>(max((int32_t{1} << 30) - b - c, int32_t{0})); }
};

/// For slivers, whose slopes overflow any accumulator: every pixel is weighed by its barycentric coordinates.
template <PrecisionTier Tier>
class SliverWeights {
public:
    constexpr SliverWeights(const TriangleSetup<Tier>& t, RasterPoint from_corner) : t_(t), offset_(from_corner) {}

    constexpr void skip_rows(int32_t rows) { offset_.y += rows * 16; }
    constexpr BarycentricWeights at(int32_t column) const {
        const int32_t x = offset_.x + column * 16;
        return {weight(multiply(x, t_.dy2) - multiply(offset_.y, t_.dx2)), weight(multiply(offset_.y, t_.dx1) - multiply(x, t_.dy1))};
    }
    constexpr uint32_t depth(BarycentricWeights w) const { return static_cast<uint32_t>(mixed(&ScreenVertex<Tier>::z, 0, w)) << 16; }
    template <class T>
    constexpr uint32_t code(T ScreenVertex<Tier>::*channel, int bits, BarycentricWeights w) const {
        const uint32_t c = static_cast<uint32_t>(mixed(channel, 24 - ScreenVertex<Tier>::channel_bits, w));
        return c * ((uint32_t{1} << bits) - 1) + (uint32_t{1} << 23);
    }

private:
    constexpr int32_t weight(int64_t numerator) const { return clamp<int32_t>(t_.inverse.times(numerator, 30), 0, int32_t{1} << 30); }
    /// An attribute between its corners' values, with `extra_bits` more fraction bits than it has.
    template <class T>
    constexpr int32_t mixed(T ScreenVertex<Tier>::*attribute, int extra_bits, BarycentricWeights w) const {
        const auto corner = [&](int i) { return static_cast<int32_t>(t_.corner[i]->*attribute) << extra_bits; };
        const int32_t lowest = min(corner(0), min(corner(1), corner(2))), highest = max(corner(0), max(corner(1), corner(2)));
        const int64_t sum = multiply(corner(1) - corner(0), w.b) + multiply(corner(2) - corner(0), w.c);
        return clamp(corner(0) + static_cast<int32_t>(shift_right_round(sum, 30)), lowest, highest);
    }

    const TriangleSetup<Tier>& t_;
    RasterPoint offset_;  // from the first corner to the reference pixel's centre
};

template <PixelFormat Format, bool Depth, PrecisionTier Tier>
class SliverPainter {
public:
    constexpr SliverPainter(const TriangleSetup<Tier>& t, RasterPoint from_corner) : weights_(t, from_corner) {}

    constexpr void skip_rows(int32_t rows) { weights_.skip_rows(rows); }
    constexpr void next_row() { skip_rows(1); }
    constexpr void span(typename Format::Pixel* pixel, uint16_t* stored, int32_t column, int32_t count) const {
        for (; count > 0; --count, ++column, ++pixel) {
            const BarycentricWeights w = weights_.at(column);
            if (!Depth || nearer<true>(stored, weights_.depth(w)))
                *pixel = detail::pixel_from_q24<Format>(weights_.code(&ScreenVertex<Tier>::r, Format::red_bits, w),
                                                        weights_.code(&ScreenVertex<Tier>::g, Format::green_bits, w),
                                                        weights_.code(&ScreenVertex<Tier>::b, Format::blue_bits, w));
            if constexpr (Depth) ++stored;
        }
    }

private:
    SliverWeights<Tier> weights_;
};

}  // namespace shade16
