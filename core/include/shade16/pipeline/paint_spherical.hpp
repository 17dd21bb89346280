// Phong shading with normals interpolated spherically: along the edges first, then along each row.
#pragma once

#include "shade16/num/arc.hpp"
#include "shade16/pipeline/paint_phong.hpp"

namespace shade16 {

namespace detail {
/// One edge with the arc between its ends' normals.
class EdgeArc {
public:
    constexpr EdgeArc() = default;
    constexpr EdgeArc(RasterPoint from, RasterPoint to, const Normal30& a, const Normal30& b) : arc_(a, b), from_(from), dx_(to.x - from.x) {
        const auto dy = static_cast<uint32_t>(max(to.y - from.y, int32_t{1}));
        shift_ = leading_zeros(dy);
        inverse_ = reciprocal_of_normalized(dy << shift_);  // 1 / dy = inverse * 2^(shift - 63)
    }
    /// How much of the edge lies above a row of the raster, Q30.
    constexpr int32_t at_row(int32_t y) const {
        const uint64_t below = static_cast<uint64_t>(max(y - from_.y, int32_t{0}));
        return static_cast<int32_t>(min<uint64_t>(below * inverse_ >> (33 - shift_), uint64_t{1} << 30));
    }
    constexpr IVec3 normal(int32_t t) const { return arc_.at(t); }
    /// In 2^-20 pixel.
    constexpr int64_t x(int32_t t) const { return (int64_t{from_.x} << 16) + (multiply(dx_, t) >> 14); }

private:
    Arc arc_{};
    RasterPoint from_{};
    int32_t dx_ = 0;
    uint32_t inverse_ = 0;
    int shift_ = 0;
};

constexpr Normal30 as_unit(const IVec3& v) { return {{v.x}, {v.y}, {v.z}}; }
}  // namespace detail

/// The normals of one row: from the left edge's to the right edge's, at an even pace.
class RowNormals {
public:
    constexpr RowNormals(const IVec3& left, const IVec3& right, int64_t left_x, int64_t right_x)
        : arc_(detail::as_unit(left), detail::as_unit(right)), left_x_(left_x) {
        const auto width = static_cast<uint32_t>(max<int64_t>(right_x - left_x, 1));
        shift_ = leading_zeros(width);
        inverse_ = reciprocal_of_normalized(width << shift_);
        const uint64_t pace = multiply(arc_.angle().turns, inverse_) >> 32;  // angle * 2^20 / width, a pixel's share
        const int down = 31 - shift_ - 20;
        const uint64_t turns = down >= 0 ? pace >> down : pace << -down;
        cosine_ = cos({static_cast<uint32_t>(min<uint64_t>(turns, uint64_t{1} << 31))}).raw;
    }
    /// The normal at a pixel whose centre is at x, in 2^-20 pixel; Q30.
    constexpr IVec3 at(int64_t x) const {
        const uint64_t along = static_cast<uint64_t>(max<int64_t>(x - left_x_, 0));
        return arc_.at(static_cast<int32_t>(min<uint64_t>(along * inverse_ >> (33 - shift_), uint64_t{1} << 30)));
    }
    /// The next along the row, from the last two: n(k + 1) = 2 cos(pace) n(k) - n(k - 1).
    /// Error   grows with the square of the number of steps, so that a caller begins anew now and then.
    constexpr IVec3 after(const IVec3& last, const IVec3& before) const {
        const auto component = [this](int32_t n, int32_t b) { return saturate(shift_right_round(multiply(n, cosine_), 29) - b); };
        return {component(last.x, before.x), component(last.y, before.y), component(last.z, before.z)};
    }

private:
    Arc arc_;
    int64_t left_x_;
    uint32_t inverse_;
    int shift_ = 0;
    int32_t cosine_ = 0;
};

/// Row after row of one triangle.
class SphericalRows {
public:
    template <PrecisionTier Tier>
    constexpr SphericalRows(const TriangleSetup<Tier>& t, const SurfaceSample (&corner)[3])
        : reference_(t.p[0].x >> 4), row_y_((first_centre(t.p[0].y) << 4) + 8), turn_y_(t.p[1].y), middle_is_right_(t.middle_is_right) {
        const Normal30 n[3] = {normalize30(corner[0].normal), normalize30(corner[1].normal), normalize30(corner[2].normal)};
        whole_ = {t.p[0], t.p[2], n[0], n[2]};
        upper_ = {t.p[0], t.p[1], n[0], n[1]};
        lower_ = {t.p[1], t.p[2], n[1], n[2]};
    }
    constexpr void skip_rows(int32_t rows) { row_y_ += rows * 16; }
    constexpr RowNormals current() const {
        const detail::EdgeArc& half = row_y_ < turn_y_ ? upper_ : lower_;
        const int32_t t = whole_.at_row(row_y_), h = half.at_row(row_y_);
        if (middle_is_right_) return {whole_.normal(t), half.normal(h), whole_.x(t), half.x(h)};
        return {half.normal(h), whole_.normal(t), half.x(h), whole_.x(t)};
    }
    /// The centre of a column that is counted from the triangle's reference, as RowNormals takes it.
    constexpr int64_t centre(int32_t column) const { return (int64_t{reference_ + column} << 20) + (int32_t{1} << 19); }

private:
    detail::EdgeArc whole_{}, upper_{}, lower_{};
    int32_t reference_, row_y_, turn_y_;
    bool middle_is_right_;
};

namespace detail {
constexpr IVec3 q29_from_q30(const IVec3& n) { return {n.x >> 1, n.y >> 1, n.z >> 1}; }
}  // namespace detail

template <Needs N, PixelFormat Format, bool Depth, PrecisionTier Tier>
class SphericalPainter {
public:
    constexpr SphericalPainter(const TriangleSetup<Tier>& t, const SurfaceSample (&corner)[3], const SamplePlanes<SurfaceKind<N, channels_of<Tier>>>& surface, const DepthPlane& depth,
                               const PixelLight<N, Tier>& light)
        : rows_(t, corner), surface_(surface), depth_(depth), light_(light) {}

    constexpr void skip_rows(int32_t rows) { rows_.skip_rows(rows), surface_.skip_rows(rows), depth_.skip_rows(rows); }
    constexpr void next_row() { skip_rows(1); }
    template <class Pixel>
    constexpr void span(Pixel pixel, uint16_t* stored, int32_t column, int32_t count) const {
        const RowNormals normals = rows_.current();
        SurfaceSample s = surface_.at(column);
        uint32_t z = depth_.at(column);
        IVec3 normal{}, before{};
        for (int32_t i = 0; i < count; ++i, ++pixel) {
            const IVec3 next = i % 16 < 2 ? normals.at(rows_.centre(column + i)) : normals.after(normal, before);
            before = normal, normal = next;
            s.normal = detail::q29_from_q30(normal);
            if (!Depth || nearer<true>(stored, z)) detail::put_lit<Format>(pixel, light_, s);
            surface_.next_pixel(s);
            z += static_cast<uint32_t>(depth_.step_x);
            if constexpr (Depth) ++stored;
        }
    }

private:
    SphericalRows rows_;
    SamplePlanes<SurfaceKind<N, channels_of<Tier>>> surface_;
    DepthPlane depth_;
    const PixelLight<N, Tier>& light_;
};

template <Needs N, PixelFormat Format, bool Depth, PrecisionTier Tier>
class SphericalSliverPainter {
public:
    constexpr SphericalSliverPainter(const TriangleSetup<Tier>& t, const SurfaceSample (&corner)[3], RasterPoint from_corner, const PixelLight<N, Tier>& light)
        : rows_(t, corner), weights_(t, from_corner), corner_(corner), light_(light) {}

    constexpr void skip_rows(int32_t rows) { rows_.skip_rows(rows), weights_.skip_rows(rows); }
    constexpr void next_row() { skip_rows(1); }
    template <class Pixel>
    constexpr void span(Pixel pixel, uint16_t* stored, int32_t column, int32_t count) const {
        const RowNormals normals = rows_.current();
        for (; count > 0; --count, ++column, ++pixel) {
            const BarycentricWeights w = weights_.at(column);
            if (!Depth || nearer<true>(stored, weights_.depth(w))) {
                SurfaceSample s = mix<SurfaceKind<N, channels_of<Tier>>>(corner_, w.a(), static_cast<uint32_t>(w.b), static_cast<uint32_t>(w.c), 30);
                s.normal = detail::q29_from_q30(normals.at(rows_.centre(column)));
                detail::put_lit<Format>(pixel, light_, s);
            }
            if constexpr (Depth) ++stored;
        }
    }

private:
    SphericalRows rows_;
    SliverWeights<Tier> weights_;
    const SurfaceSample (&corner_)[3];
    const PixelLight<N, Tier>& light_;
};

}  // namespace shade16
