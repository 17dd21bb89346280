// Stage 5, raster: the pixels of one triangle. Coverage follows the top-left rule exactly: every pixel of a closed
// surface is drawn once.
#pragma once

#include "shade16/pipeline/paint_exact.hpp"
#include "shade16/pipeline/paint_spherical.hpp"
#include "shade16/pipeline/paint_textured.hpp"
#include "shade16/pipeline/small_triangle.hpp"

namespace shade16 {

namespace detail {
/// Walks the rows of a triangle inside `box` and gives the painter each span, in columns from the reference pixel. Which
/// side the middle corner is on is known outside of the loop, so that no row asks again.
template <bool MiddleIsRight, class Painter, PixelFormat Format, PrecisionTier Tier>
SHADE16_INLINE constexpr void walk_side(const TriangleSetup<Tier>& t, const PixelBox& box, const Band<Format>& band, bool has_depth, Painter painter) {
    const RasterPoint top = t.p[0], middle = t.p[1];
    const int32_t reference = top.x >> 4, middle_row = first_centre(middle.y);
    int32_t row = box.top;
    EdgeWalker whole(top.x, top.y, t.dx2, t.dy2, row, reference);
    EdgeWalker half = row < middle_row ? EdgeWalker(top.x, top.y, t.dx1, t.dy1, row, reference)
                                             : EdgeWalker(middle.x, middle.y, t.p[2].x - middle.x, t.p[2].y - middle.y, row, reference);
    const int32_t first_column = box.left - reference, end_column = box.right - reference;

    int32_t origin = (row - band.first_row) * band.width + reference;  // where the reference column lies in the band
    for (int32_t end_row = row < middle_row ? min(middle_row, box.bottom) : box.bottom;; end_row = box.bottom) {
        for (; row < end_row; ++row) {
            const int32_t left = MiddleIsRight ? whole.column() : half.column(), right = MiddleIsRight ? half.column() : whole.column();
            const int32_t from = max(left, first_column), to = min(right, end_column);
            if (from < to) {
                uint16_t* const depth = has_depth ? band.depth + (origin + from) : nullptr;
                if constexpr (is_placed<Format>) painter.span(Place<Format>(band.row(row), reference + from, row), depth, from, to - from);
                else painter.span(band.pixels + (origin + from), depth, from, to - from);
            }
            whole.next_row();
            half.next_row();
            painter.next_row();
            origin += band.width;
        }
        if (row >= box.bottom) return;
        half = EdgeWalker(middle.x, middle.y, t.p[2].x - middle.x, t.p[2].y - middle.y, row, reference);
    }
}

template <class Painter, PixelFormat Format, PrecisionTier Tier>
SHADE16_INLINE constexpr void walk(const TriangleSetup<Tier>& t, const PixelBox& box, const Band<Format>& band, bool has_depth, Painter painter) {
    const int32_t first_row = first_centre(t.p[0].y);
    if (box.top > first_row) painter.skip_rows(box.top - first_row);
    if (t.middle_is_right) walk_side<true>(t, box, band, has_depth, painter);
    else walk_side<false>(t, box, band, has_depth, painter);
}
}  // namespace detail

/// Draws the pixels inside `box`, which is not empty and inside the band, of a triangle of any size.
/// Error   coverage none; colour packed_ or exact_stepping_max_error before rounding; depth 2 of 65536.
template <Stepping Step, bool Depth, PixelFormat Format, PrecisionTier Tier>
[[gnu::noinline]] constexpr void raster(const TriangleSetup<Tier>& t, const PixelBox& box, const Band<Format>& band) {
    const RasterPoint from_corner = t.to_reference();
    const DepthPlane depth = depth_plane<Depth>(t, from_corner);
    bool is_sliver = t.is_sliver() || (Depth && depth.is_steep());

    if constexpr (Step == Stepping::packed && PackedFormat<Format>) {
        if (!is_sliver) {
            const PackedPlanes color(t, from_corner);
            return detail::walk(t, box, band, Depth, PackedPainter<Format, Depth>(color, depth));
        }
    } else {
        const ExactPainter<Format, Depth> painter(t, depth, from_corner);
        is_sliver = is_sliver || painter.is_steep();
        if (!is_sliver) return detail::walk(t, box, band, Depth, painter);
    }
    detail::walk(t, box, band, Depth, SliverPainter<Format, Depth, Tier>(t, from_corner));
}

/// Draws what shows of a triangle in the band; some of it does.
template <Stepping Step, bool Depth, PixelFormat Format, PrecisionTier Tier>
SHADE16_INLINE constexpr void draw_triangle(const FacingTriangle<Tier>& t, const Band<Format>& band) {
    if constexpr (Step == Stepping::packed && steps_small<Format>)
        if (is_small(t.whole, band.width) && draw_small<Depth>(t, band)) return;
    raster<Step, Depth>(set_up(t), t.box(band.width), band);
}

/// A triangle whose pixels are made one by one from samples, with what walking it takes.
template <class Kind, bool Depth, PrecisionTier Tier>
struct SampledTriangle {
    using Sample = typename Kind::Sample;

    TriangleSetup<Tier> setup;
    RasterPoint from_corner;
    Sample sample[3];  // in the order of the set-up's corners
    DepthPlane depth;
    SamplePlanes<Kind> planes;
    bool is_sliver;

    constexpr SampledTriangle(const FacingTriangle<Tier>& t, const Sample (&corner)[3])
        : setup(set_up(t)), from_corner(setup.to_reference()), sample{of(t, corner, 0), of(t, corner, 1), of(t, corner, 2)},
          depth(depth_plane<Depth>(setup, from_corner)), planes(setup, sample, from_corner),
          is_sliver(is_thin(setup) || (Depth && depth.is_steep()) || is_deep()) {}

private:
    constexpr const Sample& of(const FacingTriangle<Tier>& t, const Sample (&corner)[3], int i) const {
        return corner[setup.corner[i] == t.a ? 0 : setup.corner[i] == t.b ? 1 : 2];
    }
    constexpr bool is_deep() const {
        if constexpr (Kind::by_depth) return max(sample[0].at.q, max(sample[1].at.q, sample[2].at.q)) > 0 &&
                                             min(sample[0].at.q, min(sample[1].at.q, sample[2].at.q)) < detail::least_stepped_q;
        return false;
    }
};

/// Draws what shows of a triangle in the band, each pixel made by `light` of a sample; `corner` are those at a, b and c.
template <bool Depth, class Light, PixelFormat Format, PrecisionTier Tier>
[[gnu::noinline]] constexpr void draw_samples(const FacingTriangle<Tier>& triangle, const typename Light::Kind::Sample (&corner)[3], const Light& light,
                                              const Band<Format>& band) {
    const SampledTriangle<typename Light::Kind, Depth, Tier> t(triangle, corner);
    const PixelBox box = triangle.box(band.width);
    if (t.is_sliver) detail::walk(t.setup, box, band, Depth, SampleSliverPainter<Light, Format, Depth, Tier>(t.setup, t.sample, t.from_corner, light));
    else detail::walk(t.setup, box, band, Depth, SamplePainter<Light, Format, Depth>(t.planes, t.depth, light));
}

/// The same with normals along great circles.
template <Needs N, PixelFormat Format, PrecisionTier Tier>
[[gnu::noinline]] constexpr void draw_spherical(const FacingTriangle<Tier>& triangle, const SurfaceSample (&corner)[3], const PixelLight<N, Tier>& light,
                                                const Band<Format>& band) {
    const SampledTriangle<SurfaceKind<N, channels_of<Tier>>, N.depth, Tier> t(triangle, corner);
    const PixelBox box = triangle.box(band.width);
    if (t.is_sliver) detail::walk(t.setup, box, band, N.depth, SphericalSliverPainter<N, Format, N.depth, Tier>(t.setup, t.sample, t.from_corner, light));
    else detail::walk(t.setup, box, band, N.depth, SphericalPainter<N, Format, N.depth, Tier>(t.setup, t.sample, t.planes, t.depth, light));
}

}  // namespace shade16
