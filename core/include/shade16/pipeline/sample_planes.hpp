// What is interpolated over a triangle whose pixels are made one by one: samples of a few numbers each, linear on the screen.
#pragma once

#include "shade16/pipeline/setup.hpp"

namespace shade16 {

/// A kind of sample: its type, and a visitor that calls f with the same number of one or more samples, for each that is needed.
template <class K>
concept SampleKind = requires(typename K::Sample s) { K::for_each_number([](int32_t&) {}, s); };

/// A mixture of three corners; the weights have `bits` fraction bits and add up to about 1.
template <SampleKind Kind>
constexpr typename Kind::Sample mix(const typename Kind::Sample (&corner)[3], uint32_t a, uint32_t b, uint32_t c, int bits) {
    typename Kind::Sample s;
    Kind::for_each_number(
        [&](int32_t& out, int32_t x, int32_t y, int32_t z) {
            out = saturate((multiply(x, a) + multiply(y, b) + multiply(z, c)) >> bits);
        },
        s, corner[0], corner[1], corner[2]);
    return s;
}

/// Whether a triangle is so thin that some number's slope might not fit 32 bits. Numbers are below 2^29, their differences below 2^30, and
/// an edge is below 2^reach_bits: with an area above 32 of those a slope is below 2^30 a pixel. It is asked of the triangle alone, so that
/// numbers which a pipeline carries besides decide nothing.
template <PrecisionTier Tier>
constexpr bool is_thin(const TriangleSetup<Tier>& t) {
    return t.area >> 5 <= uint64_t{1} << t.reach_bits;
}

/// How a sample changes over a triangle that is not thin: its value at the reference pixel of the current row, and its slopes.
template <SampleKind Kind>
struct SamplePlanes {
    using Sample = typename Kind::Sample;
    Sample value{}, step_x{}, step_y{};

    /// `corner` in the order of the set-up's own corners.
    template <PrecisionTier Tier>
    constexpr SamplePlanes(const TriangleSetup<Tier>& t, const Sample (&corner)[3], RasterPoint from_corner) {
        Kind::for_each_number(
            [&](int32_t& v, int32_t& dx, int32_t& dy, int32_t c0, int32_t c1, int32_t c2) {
                dx = t.inverse.times(t.long_slope_x(c1 - c0, c2 - c0), 4);
                dy = t.inverse.times(t.long_slope_y(c1 - c0, c2 - c0), 4);
                v = static_cast<int32_t>(c0 + ((multiply(dx, from_corner.x) + multiply(dy, from_corner.y)) >> 4));
            },
            value, step_x, step_y, corner[0], corner[1], corner[2]);
    }
    constexpr void skip_rows(int32_t rows) { move(value, step_y, rows); }
    SHADE16_INLINE constexpr Sample at(int32_t column) const {
        Sample s = value;
        move(s, step_x, column);
        return s;
    }
    SHADE16_INLINE constexpr void next_pixel(Sample& s) const { move(s, step_x, 1); }

private:
    /// Modulo 2^32: steps may lead far outside, values at covered pixels are inside.
    SHADE16_INLINE static constexpr void move(Sample& s, const Sample& step, int32_t n) {
        Kind::for_each_number(
            [n](int32_t& v, int32_t d) { v = static_cast<int32_t>(static_cast<uint32_t>(v) + static_cast<uint32_t>(d) * static_cast<uint32_t>(n)); }, s, step);
    }
};

}  // namespace shade16
