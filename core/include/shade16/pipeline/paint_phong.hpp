// Phong shading: every pixel is lit by itself.
#pragma once

#include "shade16/pipeline/paint_exact.hpp"
#include "shade16/pipeline/surface.hpp"

namespace shade16 {

/// What lights the pixels of one object.
template <Needs N, PrecisionTier Tier>
struct PixelLight {
    const ObjectLighting<Tier>& lighting;
    View<ObjectLight<Tier>> lights;
    const Shininess<Tier>* shininess;
    bool has_colors;

    /// Error   as light_point, with the normal's renormalisation once more.
    /// Cost    that of a vertex, and a square root.
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr typename Format::Pixel pixel(const SurfaceSample& s) const {
        SurfacePoint point{};
        if constexpr (detail::carries_position(N)) {
            if constexpr (Arithmetic<Tier>::wide) point = {s.position, 8192};
            else point = {{s.position.x >> 11, s.position.y >> 11, s.position.z >> 11}, 4};
        }
        Rgb color{};
        if constexpr (N.vertex_colors) color = {unorm(s.color.x), unorm(s.color.y), unorm(s.color.z)};
        const Accumulator sum = light_point<N>(lighting, lights, shininess, point, UnitVectorOf<Tier>::normalize(s.normal), has_colors ? &color : nullptr);
        const auto code = [](uint32_t c, int bits) { return min(c, Accumulator::one) * ((uint32_t{1} << bits) - 1) + (uint32_t{1} << 23); };
        return detail::pixel_from_q24<Format>(code(sum.r, Format::red_bits), code(sum.g, Format::green_bits), code(sum.b, Format::blue_bits));
    }

private:
    static constexpr Unorm16 unorm(int32_t q13) { return Unorm16::from_raw(static_cast<uint32_t>(clamp<int32_t>(shift_right_round(q13, 13), 0, 65535))); }
};

template <Needs N, PixelFormat Format, bool Depth, PrecisionTier Tier>
class PhongPainter {
public:
    constexpr PhongPainter(const SurfacePlanes<N>& surface, const DepthPlane& depth, const PixelLight<N, Tier>& light)
        : surface_(surface), depth_(depth), light_(light) {}

    constexpr void skip_rows(int32_t rows) { surface_.skip_rows(rows), depth_.skip_rows(rows); }
    SHADE16_INLINE constexpr void next_row() { skip_rows(1); }
    SHADE16_INLINE constexpr void span(typename Format::Pixel* pixel, uint16_t* stored, int32_t column, int32_t count) const {
        SurfaceSample s = surface_.at(column);
        uint32_t z = depth_.at(column);
        for (; count > 0; --count, ++pixel) {
            if (!Depth || nearer<true>(stored, z)) *pixel = light_.template pixel<Format>(s);
            surface_.next_pixel(s);
            z += static_cast<uint32_t>(depth_.step_x);
            if constexpr (Depth) ++stored;
        }
    }

private:
    SurfacePlanes<N> surface_;
    DepthPlane depth_;
    const PixelLight<N, Tier>& light_;
};

/// For slivers: every pixel's sample is weighed by its barycentric coordinates.
template <Needs N, PixelFormat Format, bool Depth, PrecisionTier Tier>
class PhongSliverPainter {
public:
    constexpr PhongSliverPainter(const TriangleSetup<Tier>& t, const SurfaceSample (&corner)[3], RasterPoint from_corner, const PixelLight<N, Tier>& light)
        : weights_(t, from_corner), corner_(corner), light_(light) {}

    constexpr void skip_rows(int32_t rows) { weights_.skip_rows(rows); }
    constexpr void next_row() { skip_rows(1); }
    constexpr void span(typename Format::Pixel* pixel, uint16_t* stored, int32_t column, int32_t count) const {
        for (; count > 0; --count, ++column, ++pixel) {
            const BarycentricWeights w = weights_.at(column);
            if (!Depth || nearer<true>(stored, weights_.depth(w)))
                *pixel = light_.template pixel<Format>(mix<N>(corner_, w.a(), static_cast<uint32_t>(w.b), static_cast<uint32_t>(w.c), 30));
            if constexpr (Depth) ++stored;
        }
    }

private:
    SliverWeights<Tier> weights_;
    const SurfaceSample (&corner_)[3];
    const PixelLight<N, Tier>& light_;
};

}  // namespace shade16
