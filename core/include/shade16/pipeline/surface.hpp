// What Phong shading interpolates: the surface itself, normal, position and colour, in place of its light.
#pragma once

#include "shade16/pipeline/light.hpp"
#include "shade16/pipeline/sample_planes.hpp"
#include "shade16/pipeline/texture_lookup.hpp"

namespace shade16 {

/// One point of the surface. Interpolated linearly over the screen, like colours; a normal is renormalised where it is lit.
struct SurfaceSample {
    IVec3 normal{};    // Q29, of any length up to 1
    IVec3 position{};  // of the lattice, with 13 fraction bits
    IVec3 color{};     // Q29, of a mesh with vertex colours; x alone, their luma, in a grey pipeline
    TextureSample at{};
};

namespace detail {
/// With lights at infinity and an infinite viewer alone, nothing asks where a point is.
constexpr bool carries_position(Needs n) { return n.point || n.local_viewer; }

SHADE16_INLINE constexpr IVec3 as_q29(const Normal14& n) { return {int32_t{n.x.raw} * 32768, int32_t{n.y.raw} * 32768, int32_t{n.z.raw} * 32768}; }
SHADE16_INLINE constexpr IVec3 as_q29(const Normal30& n) { return {n.x.raw >> 1, n.y.raw >> 1, n.z.raw >> 1}; }

constexpr bool looks_up(Needs n) { return n.texture || n.bump; }

template <Needs N, class F, class... Sample>
SHADE16_INLINE constexpr void for_each_coordinate(F f, Sample&... s) {
    if constexpr (looks_up(N)) f(s.at.s...), f(s.at.t...);
    if constexpr (looks_up(N) && N.perspective_texture) f(s.at.q...);
}
}  // namespace detail

template <Needs N, Channels C = Channels::rgb>
struct SurfaceKind {
    using Sample = SurfaceSample;
    static constexpr bool by_depth = detail::looks_up(N) && N.perspective_texture;
    template <class F, class... S>
    SHADE16_INLINE static constexpr void for_each_number(F f, S&... s) {
        f(s.normal.x...), f(s.normal.y...), f(s.normal.z...);
        if constexpr (detail::carries_position(N)) f(s.position.x...), f(s.position.y...), f(s.position.z...);
        if constexpr (N.vertex_colors) f(s.color.x...);
        if constexpr (N.vertex_colors && C == Channels::rgb) f(s.color.y...), f(s.color.z...);
        detail::for_each_coordinate<N>(f, s...);
    }
};

/// Where a vertex lies in the textures, before any divide.
constexpr TextureSample texture_sample_at(const Mesh& mesh, uint32_t index) {
    if (mesh.texcoords.empty()) return {};
    const TexCoord16 at = mesh.texcoords[index];
    return {int32_t{at.s} * 8192, int32_t{at.t} * 8192, 0};
}

template <Channels C>
SHADE16_INLINE constexpr IVec3 color_in_q29(const Rgb& c) {
    if constexpr (C == Channels::luma) return {static_cast<int32_t>(luma_of(c).luma >> 3), 0, 0};
    else return {static_cast<int32_t>(c.r.widened() >> 3), static_cast<int32_t>(c.g.widened() >> 3), static_cast<int32_t>(c.b.widened() >> 3)};
}

/// The surface at a vertex.
template <Needs N, PrecisionTier Tier>
constexpr SurfaceSample surface_at(const Mesh& mesh, const ObjectLighting<Tier>& lighting, uint32_t index) {
    SurfaceSample s;
    if (!mesh.normals.empty()) s.normal = detail::as_q29(lighting_normal<N>(lighting, mesh.normals[index]));
    const Position16 p = mesh.positions[index];
    s.position = {int32_t{p.x} * 8192, int32_t{p.y} * 8192, int32_t{p.z} * 8192};
    if (!mesh.colors.empty()) s.color = color_in_q29<channels_of<Tier>>(mesh.colors[index]);
    if constexpr (detail::looks_up(N)) s.at = texture_sample_at(mesh, index);
    return s;
}

}  // namespace shade16
