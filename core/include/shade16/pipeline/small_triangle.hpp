// Small triangles, which meshes are made of: stepped by one addition a row and a pixel.
#pragma once

#include "shade16/pipeline/small_edge.hpp"
#include "shade16/pipeline/small_exact.hpp"

namespace shade16 {

namespace detail {
/// `count` pixels before `end`, in both arrays by one index, which counts up to 0.
template <PackedFormat Format, bool Depth>
SHADE16_INLINE constexpr void small_span(typename Format::Pixel* end, uint16_t* depth_end, int32_t count, uint32_t word, uint32_t word_x, uint32_t z,
                                         uint32_t z_x) {
    end = opaque(end), depth_end = opaque(depth_end);
    int32_t i = -count;
    do {
        if (!Depth || nearer<true>(depth_end + i, z)) end[i] = Format::from_word(word);
        word += word_x;
        if constexpr (Depth) z += z_x;
        i = opaque(i) + 1;
    } while (i != 0);
}

template <PixelFormat Format, bool Depth>
struct SmallPlanesOf {
    using type = SmallExactPlanes<Format, Depth>;
};
template <PackedFormat Format, bool Depth>
struct SmallPlanesOf<Format, Depth> {
    using type = SmallPlanes<Depth>;
};

/// A small triangle ready for its rows. Points, rows and planes count from the middle pixel.
template <PixelFormat Format, bool Depth>
struct SmallTriangle {
    typename SmallPlanesOf<Format, Depth>::type planes;
    RasterPoint corner[5];  // the first two again at the end
    int32_t top;            // the topmost one; the next is on its left and the one after on its right
    int32_t first_row, end_row, middle, width;
    typename Format::Pixel* pixels;
    uint16_t* depth;

    /// Number by number: GCC would copy points by way of memory.
    SHADE16_INLINE constexpr void set_corners(const RasterPoint& p, const RasterPoint& q, const RasterPoint& r) {
        corner[0].x = corner[3].x = p.x, corner[0].y = corner[3].y = p.y;
        corner[1].x = corner[4].x = q.x, corner[1].y = corner[4].y = q.y;
        corner[2].x = r.x, corner[2].y = r.y;
        top = p.y <= q.y && p.y <= r.y ? 0 : q.y <= r.y ? 1 : 2;
    }
};

/// Draws rows until `end`, and leaves the edges at it.
template <PixelFormat Format, bool Depth>
SHADE16_INLINE constexpr void walk_small(const SmallTriangle<Format, Depth>& t, SmallEdge& left, SmallEdge& right, int32_t& row, int32_t end) {
    for (int32_t offset = row * t.width + t.middle; row < end; ++row, offset += t.width) {
        const int32_t from = left.column(), to = right.column(), count = to - from;
        left.next_row();
        right.next_row();
        if (count <= 0) continue;
        // The planes are only read here, afresh: what all rows share is too much for the registers.
        const auto x = static_cast<uint32_t>(from), y = static_cast<uint32_t>(row);
        const auto& p = t.planes;
        if constexpr (!PackedFormat<Format>) {
            uint16_t* const depth = Depth ? t.depth + (offset + from) : nullptr;
            if constexpr (is_placed<Format>) {
                const int32_t in_frame = p.row + row;
                auto* const pixels = t.pixels + (in_frame - p.first_row) * pixels_a_row<Format>(t.width);
                small_exact_span<Format, Depth>(p, Place<Format>(pixels, p.column + from, in_frame), depth, count, x, y);
            } else {
                small_exact_span<Format, Depth>(p, t.pixels + (offset + from), depth, count, x, y);
            }
            continue;
        } else {
            const uint32_t word = opaque(p.word + p.word_y * y) + p.word_x * x;
            const auto end_pixel = t.pixels + (offset + to);
            if constexpr (Depth) small_span<Format, true>(end_pixel, t.depth + (offset + to), count, word, p.word_x, opaque(p.z + p.z_y * y) + p.z_x * x, p.z_x);
            else small_span<Format, false>(end_pixel, nullptr, count, word, p.word_x, 0, 0);
        }
    }
}

template <PixelFormat Format, bool Depth>
[[gnu::noinline]] constexpr void draw_rows(const SmallTriangle<Format, Depth>& t) {
    const RasterPoint &a = t.corner[t.top], &b = t.corner[t.top + 1], &c = t.corner[t.top + 2];
    const int32_t left_turn = centre_beyond(b.y), right_turn = centre_beyond(c.y), turn = min(left_turn, right_turn);
    int32_t row = t.first_row;
    SmallEdge left(row < left_turn ? a : b, row < left_turn ? b : c, row);
    SmallEdge right(row < right_turn ? a : c, row < right_turn ? c : b, row);
    if (row < turn) {
        walk_small(t, left, right, row, min(turn, t.end_row));
        if (row >= t.end_row) return;
        if (left_turn <= right_turn) left = SmallEdge(b, c, row);
        else right = SmallEdge(c, b, row);
    }
    walk_small(t, left, right, row, t.end_row);
}
}  // namespace detail

/// Whether a format's small triangles are drawn here, in the 16-bit tiers: all but those of 8 bits in each of three channels.
template <PixelFormat Format>
inline constexpr bool steps_small = [] {
    if constexpr (GrayFormat<Format>) return true;
    else return Format::red_bits < 8;
}();

/// Draws the rows in the band of a facing triangle for which is_small holds. False, and nothing drawn, where it is too
/// thin or its depth too steep for 32 bits.
/// Error   coverage none; colour packed_ or exact_stepping_max_error before rounding; depth 2 of 65536.
/// Cost    M3: about 300 instructions, 35 a row, 14 a pixel.
template <bool Depth, PixelFormat Format, PrecisionTier Tier>
[[gnu::noinline]] constexpr bool draw_small(const FacingTriangle<Tier>& facing, const Band<Format>& band) {
    const PixelBox& whole = facing.whole;
    const int32_t column = (whole.left + whole.right) >> 1, row = (whole.top + whole.bottom) >> 1;
    const RasterPoint middle{shift_left(column, 4) + 8 - facing.centre.x, shift_left(row, 4) + 8 - facing.centre.y};
    const auto point = [middle](const ScreenVertex<Tier>& v) { return RasterPoint{v.x - middle.x, v.y - middle.y}; };
    const RasterPoint p = point(*facing.a), q = point(*facing.b), r = point(*facing.c);
    detail::SmallTriangle<Format, Depth> t;
    if (!t.planes.set(*facing.a, *facing.b, *facing.c, p, q, r, (whole.right - whole.left) + (whole.bottom - whole.top))) return false;

    if constexpr (!PackedFormat<Format>) t.planes.column = column, t.planes.row = row, t.planes.first_row = band.first_row;
    t.set_corners(p, q, r);
    t.first_row = facing.first_row - row, t.end_row = facing.end_row - row;
    t.middle = (row - band.first_row) * band.width + column;
    t.width = band.width, t.pixels = band.pixels, t.depth = band.depth;
    detail::draw_rows(t);
    return true;
}

}  // namespace shade16
