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

    constexpr ExactPlane() = default;
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
/// A pixel's own light in Q24 codes, saturated.
template <PixelFormat Format, Channels C>
SHADE16_INLINE constexpr ByChannel<C, uint32_t> codes_of_light(const AccumulatorOf<C>& sum) {
    ByChannel<C, uint32_t> q24;
    const auto every_bits = channel_bits<Format>();
    for_each_channel<C>([](uint32_t& code, uint32_t c, int bits) { code = min(c, Accumulator::one) * ((uint32_t{1} << bits) - 1) + q24_bias<Format>(); }, q24, sum,
                        every_bits);
    return q24;
}
/// The same as a pixel, where that does not depend on its place.
template <PixelFormat Format, Channels C>
SHADE16_INLINE constexpr typename Format::Pixel pixel_of_light(const AccumulatorOf<C>& sum) {
    typename Format::Pixel pixel;
    put<Format>(&pixel, codes_of_light<Format>(sum));
    return pixel;
}
}  // namespace detail

/// Every channel of a format over a triangle.
template <PixelFormat Format>
struct ExactPlanes {
    static constexpr Channels channels = channels_of_format<Format>;
    using Codes = ByChannel<channels, uint32_t>;
    ByChannel<channels, ExactPlane> plane;

    template <PrecisionTier Tier>
    constexpr ExactPlanes(const TriangleSetup<Tier>& t, RasterPoint from_corner) : plane(planes_of(t, from_corner)) {
        constexpr uint32_t to_bias = detail::q24_bias<Format>() - detail::q24_bias<Rgb888>();  // from half a code
        if constexpr (to_bias != 0) for_each_channel<channels>([](ExactPlane& p) { p.value += to_bias; }, plane);
    }

    constexpr bool is_steep() const {
        bool steep = false;
        for_each_channel<channels>([&](const ExactPlane& p) { steep = steep || p.is_steep(); }, plane);
        return steep;
    }
    constexpr void skip_rows(int32_t rows) {
        for_each_channel<channels>([&](ExactPlane& p) { p.skip_rows(rows); }, plane);
    }
    SHADE16_INLINE constexpr Codes at(int32_t column) const {
        Codes c;
        for_each_channel<channels>([&](uint32_t& code, const ExactPlane& p) { code = p.at(column); }, c, plane);
        return c;
    }
    SHADE16_INLINE constexpr void next_pixel(Codes& c) const {
        for_each_channel<channels>([](uint32_t& code, const ExactPlane& p) { code += static_cast<uint32_t>(p.step_x); }, c, plane);
    }

private:
    template <PrecisionTier Tier>
    static constexpr ByChannel<channels, ExactPlane> planes_of(const TriangleSetup<Tier>& t, RasterPoint from_corner) {
        using Vertex = ScreenVertex<Tier>;
        if constexpr (channels == Channels::luma)
            return {{t, &Vertex::luma, Format::luma_bits, from_corner}};
        else
            return {{t, &Vertex::r, Format::red_bits, from_corner}, {t, &Vertex::g, Format::green_bits, from_corner},
                    {t, &Vertex::b, Format::blue_bits, from_corner}};
    }
};

template <PixelFormat Format, bool Depth>
class ExactPainter {
public:
    template <PrecisionTier Tier>
    constexpr ExactPainter(const TriangleSetup<Tier>& t, const DepthPlane& depth, RasterPoint from_corner) : color_(t, from_corner), depth_(depth) {}

    constexpr bool is_steep() const { return color_.is_steep(); }
    constexpr void skip_rows(int32_t rows) { color_.skip_rows(rows), depth_.skip_rows(rows); }
    SHADE16_INLINE constexpr void next_row() { skip_rows(1); }
    template <class Pixel>
    SHADE16_INLINE constexpr void span(Pixel pixel, uint16_t* stored, int32_t column, int32_t count) const {
        auto c = color_.at(column);
        uint32_t z = depth_.at(column);
        for (; count > 0; --count, ++pixel) {
            if (nearer<Depth>(stored, z)) detail::put<Format>(pixel, c);
            color_.next_pixel(c);
            z += static_cast<uint32_t>(depth_.step_x);
            if constexpr (Depth) ++stored;
        }
    }

private:
    ExactPlanes<Format> color_;
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
    template <PixelFormat Format, class T>
    constexpr uint32_t code(T ScreenVertex<Tier>::*channel, int bits, BarycentricWeights w) const {
        const uint32_t c = static_cast<uint32_t>(mixed(channel, 24 - ScreenVertex<Tier>::channel_bits, w));
        return c * ((uint32_t{1} << bits) - 1) + detail::q24_bias<Format>();
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
    template <class Pixel>
    constexpr void span(Pixel pixel, uint16_t* stored, int32_t column, int32_t count) const {
        for (; count > 0; --count, ++column, ++pixel) {
            const BarycentricWeights w = weights_.at(column);
            if (!Depth || nearer<true>(stored, weights_.depth(w))) detail::put<Format>(pixel, codes(w));
            if constexpr (Depth) ++stored;
        }
    }

private:
    constexpr ByChannel<channels_of_format<Format>, uint32_t> codes(BarycentricWeights w) const {
        using Vertex = ScreenVertex<Tier>;
        if constexpr (GrayFormat<Format>)
            return {weights_.template code<Format>(&Vertex::luma, Format::luma_bits, w)};
        else
            return {weights_.template code<Format>(&Vertex::r, Format::red_bits, w), weights_.template code<Format>(&Vertex::g, Format::green_bits, w),
                    weights_.template code<Format>(&Vertex::b, Format::blue_bits, w)};
    }

    SliverWeights<Tier> weights_;
};

}  // namespace shade16
