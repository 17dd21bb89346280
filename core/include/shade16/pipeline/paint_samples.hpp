// Painters for pixels that are made one by one from an interpolated sample: `Light` says of what kind the samples are, and
// makes a pixel of one.
#pragma once

#include "shade16/pipeline/paint_exact.hpp"
#include "shade16/pipeline/sample_planes.hpp"

namespace shade16 {

namespace detail {
/// Writes what `light` makes of a sample. A pixel that depends on its place is rounded where it is put.
template <PixelFormat Format, class Light, class Sample>
SHADE16_INLINE constexpr void put_lit(typename Format::Pixel* pixel, const Light& light, const Sample& s) {
    *pixel = light.template pixel<Format>(s);
}
template <PixelFormat Format, class Light, class Sample>
SHADE16_INLINE constexpr void put_lit(const Place<Format>& place, const Light& light, const Sample& s) {
    put<Format>(place, light.template codes<Format>(s));
}
}  // namespace detail

template <class Light, PixelFormat Format, bool Depth>
class SamplePainter {
public:
    constexpr SamplePainter(const SamplePlanes<typename Light::Kind>& planes, const DepthPlane& depth, const Light& light)
        : planes_(planes), depth_(depth), light_(light) {}

    constexpr void skip_rows(int32_t rows) { planes_.skip_rows(rows), depth_.skip_rows(rows); }
    SHADE16_INLINE constexpr void next_row() { skip_rows(1); }
    template <class Pixel>
    SHADE16_INLINE constexpr void span(Pixel pixel, uint16_t* stored, int32_t column, int32_t count) const {
        auto s = planes_.at(column);
        uint32_t z = depth_.at(column);
        for (; count > 0; --count, ++pixel) {
            if (!Depth || nearer<true>(stored, z)) detail::put_lit<Format>(pixel, light_, s);
            planes_.next_pixel(s);
            z += static_cast<uint32_t>(depth_.step_x);
            if constexpr (Depth) ++stored;
        }
    }

private:
    SamplePlanes<typename Light::Kind> planes_;
    DepthPlane depth_;
    const Light& light_;
};

/// For slivers: every pixel's sample is weighed by its barycentric coordinates.
template <class Light, PixelFormat Format, bool Depth, PrecisionTier Tier>
class SampleSliverPainter {
public:
    using Sample = typename Light::Kind::Sample;

    constexpr SampleSliverPainter(const TriangleSetup<Tier>& t, const Sample (&corner)[3], RasterPoint from_corner, const Light& light)
        : weights_(t, from_corner), corner_(corner), light_(light) {}

    constexpr void skip_rows(int32_t rows) { weights_.skip_rows(rows); }
    constexpr void next_row() { skip_rows(1); }
    template <class Pixel>
    constexpr void span(Pixel pixel, uint16_t* stored, int32_t column, int32_t count) const {
        for (; count > 0; --count, ++column, ++pixel) {
            const BarycentricWeights w = weights_.at(column);
            if (!Depth || nearer<true>(stored, weights_.depth(w)))
                detail::put_lit<Format>(pixel, light_, mix<typename Light::Kind>(corner_, w.a(), static_cast<uint32_t>(w.b), static_cast<uint32_t>(w.c), 30));
            if constexpr (Depth) ++stored;
        }
    }

private:
    SliverWeights<Tier> weights_;
    const Sample (&corner_)[3];
    const Light& light_;
};

}  // namespace shade16
