// Stage 5, raster: the pixels of one triangle. Coverage follows the top-left rule exactly: every pixel of a closed
// surface is drawn once.
#pragma once

#include "shade16/pipeline/paint_exact.hpp"
#include "shade16/pipeline/paint_packed.hpp"

namespace shade16 {

namespace detail {
/// Walks the rows of a triangle inside `box` and gives the painter each span, in columns from the reference pixel.
template <class Painter, PixelFormat Format, PrecisionTier Tier>
SHADE16_INLINE constexpr void walk(const TriangleSetup<Tier>& t, const PixelBox& box, const Band<Format>& band, bool has_depth, Painter painter) {
    const RasterPoint top = t.p[0], middle = t.p[1];
    const int32_t reference = top.x >> 4, first_row = first_centre(top.y);
    int32_t row = box.top;
    if (row > first_row) painter.skip_rows(row - first_row);

    const int32_t middle_row = first_centre(middle.y);
    const EdgeWalker whole(top.x, top.y, t.dx2, t.dy2, row);
    const auto upper = [&] { return EdgeWalker(top.x, top.y, t.dx1, t.dy1, row); };
    const auto lower = [&] { return EdgeWalker(middle.x, middle.y, t.p[2].x - middle.x, t.p[2].y - middle.y, row); };
    EdgeWalker half = row < middle_row ? upper() : lower();
    EdgeWalker left = t.middle_is_right ? whole : half, right = t.middle_is_right ? half : whole;

    typename Format::Pixel* pixels = band.row(row) + reference;
    uint16_t* depth = has_depth ? band.depth_row(row) + reference : nullptr;
    while (true) {
        const int32_t end_row = row < middle_row ? min(middle_row, box.bottom) : box.bottom;
        for (; row < end_row; ++row) {
            const int32_t from = max(left.pixel(), box.left) - reference, to = min(right.pixel(), box.right) - reference;
            if (from < to) painter.span(pixels + from, has_depth ? depth + from : nullptr, from, to - from);
            left.next_row();
            right.next_row();
            painter.next_row();
            pixels += band.width;
            if (has_depth) depth += band.width;
        }
        if (row >= box.bottom) return;
        (t.middle_is_right ? right : left) = lower();
    }
}
}  // namespace detail

/// Draws a triangle's pixels inside `box`, which is not empty and inside the band.
/// Error   coverage none; colour packed_ or exact_stepping_max_error before rounding; depth 1 of 65536.
template <Stepping Step, bool Depth, PixelFormat Format, PrecisionTier Tier>
constexpr void raster(const TriangleSetup<Tier>& t, const PixelBox& box, const Band<Format>& band) {
    const RasterPoint from_corner{8 - (t.p[0].x & 15), (first_centre(t.p[0].y) << 4) + 8 - t.p[0].y};
    const DepthPlane depth(t, from_corner);
    bool is_sliver = t.is_sliver() || (Depth && depth.is_steep());

    if constexpr (Step == Stepping::packed && PackedFormat<Format>) {
        if (!is_sliver) {
            const PackedPlanes color(t, from_corner);
            const int32_t size = (t.p[2].y - t.p[0].y) + static_cast<int32_t>(max(magnitude(t.dx1), max(magnitude(t.dx2), magnitude(t.dx2 - t.dx1))));
            if (size <= small_triangle_px * 16) return detail::walk(t, box, band, Depth, SmallPackedPainter<Format, Depth>(color, depth));
            return detail::walk(t, box, band, Depth, PackedPainter<Format, Depth>(color, depth));
        }
    } else {
        const ExactPainter<Format, Depth> painter(t, depth, from_corner);
        is_sliver = is_sliver || painter.is_steep();
        if (!is_sliver) return detail::walk(t, box, band, Depth, painter);
    }
    detail::walk(t, box, band, Depth, SliverPainter<Format, Depth, Tier>(t, from_corner));
}

}  // namespace shade16
