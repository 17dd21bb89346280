// What Phong shading interpolates: the surface itself, normal, position and colour, in place of its light.
#pragma once

#include "shade16/pipeline/light.hpp"
#include "shade16/pipeline/setup.hpp"

namespace shade16 {

/// One point of the surface. Interpolated linearly over the screen, like colours; a normal is renormalised where it is lit.
struct SurfaceSample {
    IVec3 normal{};    // Q29, of any length up to 1
    IVec3 position{};  // of the lattice, with 13 fraction bits
    IVec3 color{};     // Q29, of a mesh with vertex colours
};

namespace detail {
/// With lights at infinity and an infinite viewer alone, nothing asks where a point is.
constexpr bool carries_position(Needs n) { return n.point || n.local_viewer; }

SHADE16_INLINE constexpr IVec3 as_q29(const Normal14& n) { return {int32_t{n.x.raw} * 32768, int32_t{n.y.raw} * 32768, int32_t{n.z.raw} * 32768}; }
SHADE16_INLINE constexpr IVec3 as_q29(const Normal30& n) { return {n.x.raw >> 1, n.y.raw >> 1, n.z.raw >> 1}; }

/// f of every number that the needs carry, of one or more samples.
template <Needs N, class F, class... Sample>
SHADE16_INLINE constexpr void for_each_number(F f, Sample&... s) {
    f(s.normal.x...), f(s.normal.y...), f(s.normal.z...);
    if constexpr (carries_position(N)) f(s.position.x...), f(s.position.y...), f(s.position.z...);
    if constexpr (N.vertex_colors) f(s.color.x...), f(s.color.y...), f(s.color.z...);
}
}  // namespace detail

/// The surface at a vertex.
template <Needs N, PrecisionTier Tier>
constexpr SurfaceSample surface_at(const Mesh& mesh, const ObjectLighting<Tier>& lighting, uint32_t index) {
    SurfaceSample s;
    if (!mesh.normals.empty()) s.normal = detail::as_q29(lighting_normal<N>(lighting, mesh.normals[index]));
    const Position16 p = mesh.positions[index];
    s.position = {int32_t{p.x} * 8192, int32_t{p.y} * 8192, int32_t{p.z} * 8192};
    const auto in_q29 = [](Unorm16 c) { return int32_t{c.raw} * 8192; };
    if (!mesh.colors.empty()) s.color = {in_q29(mesh.colors[index].r), in_q29(mesh.colors[index].g), in_q29(mesh.colors[index].b)};
    return s;
}

/// A mixture of three corners; the weights have `bits` fraction bits and add up to about 1.
template <Needs N>
constexpr SurfaceSample mix(const SurfaceSample (&corner)[3], uint32_t a, uint32_t b, uint32_t c, int bits) {
    SurfaceSample s;
    detail::for_each_number<N>(
        [&](int32_t& out, int32_t x, int32_t y, int32_t z) {
            out = saturate((multiply(x, a) + multiply(y, b) + multiply(z, c)) >> bits);
        },
        s, corner[0], corner[1], corner[2]);
    return s;
}

/// How a sample changes over a triangle: its value at the reference pixel of the current row, and its slopes.
template <Needs N>
struct SurfacePlanes {
    SurfaceSample value{}, step_x{}, step_y{};
    bool is_steep = false;  // a slope beyond 32 bits: of a sliver

    /// `corner` in the order of the set-up's own corners.
    template <PrecisionTier Tier>
    constexpr SurfacePlanes(const TriangleSetup<Tier>& t, const SurfaceSample (&corner)[3], RasterPoint from_corner) {
        detail::for_each_number<N>(
            [&](int32_t& v, int32_t& dx, int32_t& dy, int32_t c0, int32_t c1, int32_t c2) {
                dx = t.inverse.times(t.long_slope_x(c1 - c0, c2 - c0), 4);
                dy = t.inverse.times(t.long_slope_y(c1 - c0, c2 - c0), 4);
                is_steep = is_steep || (magnitude(dx) | magnitude(dy)) >= (uint32_t{1} << 30);
                v = static_cast<int32_t>(c0 + ((multiply(dx, from_corner.x) + multiply(dy, from_corner.y)) >> 4));
            },
            value, step_x, step_y, corner[0], corner[1], corner[2]);
    }
    constexpr void skip_rows(int32_t rows) { move(value, step_y, rows); }
    SHADE16_INLINE constexpr SurfaceSample at(int32_t column) const {
        SurfaceSample s = value;
        move(s, step_x, column);
        return s;
    }
    SHADE16_INLINE constexpr void next_pixel(SurfaceSample& s) const { move(s, step_x, 1); }

private:
    /// Modulo 2^32: steps may lead far outside, values at covered pixels are inside.
    SHADE16_INLINE static constexpr void move(SurfaceSample& s, const SurfaceSample& step, int32_t n) {
        detail::for_each_number<N>(
            [n](int32_t& v, int32_t d) { v = static_cast<int32_t>(static_cast<uint32_t>(v) + static_cast<uint32_t>(d) * static_cast<uint32_t>(n)); }, s, step);
    }
};

}  // namespace shade16
