// The tangent plane of a face, which a relief map is given in.
#pragma once

#include "shade16/pipeline/light_setup.hpp"

namespace shade16 {

/// Unit vectors along which s and t grow on a face, in the frame of lighting; zero where the texture has no area.
struct FaceTangents {
    Normal30 along_s{}, along_t{};
};

namespace detail {
/// An edge of a face in 3 + 2 dimensions.
struct TexturedEdge {
    IVec3 position{};
    int32_t s = 0, t = 0;
};

/// a * x - b * y by component, as a direction.
constexpr Normal30 combined(const IVec3& a, int32_t x, const IVec3& b, int32_t y) {
    const auto component = [=](int32_t p, int32_t q) { return multiply(p, x) - multiply(q, y); };
    const int64_t u = component(a.x, b.x), v = component(a.y, b.y), w = component(a.z, b.z);
    const int excess = max(0, 34 - leading_zeros(magnitude(u) | magnitude(v) | magnitude(w)));
    const auto shortened = [excess](int64_t c) { return static_cast<int32_t>(shift_right_round(c, excess)); };
    return normalize_finely({shortened(u), shortened(v), shortened(w)});
}
}  // namespace detail

/// Source  the gradient of (s, t) over the triangle: position = along_s * s + along_t * t on both edges, solved.
/// Error   2^-28.
template <Needs N>
SHADE16_ONCE constexpr FaceTangents face_tangents(const Mesh& mesh, const Triangle& face, [[maybe_unused]] const Stretch& stretch) {
    const auto edge_to = [&](uint16_t corner) {
        const Position16 p = mesh.positions[corner], from = mesh.positions[face.a];
        const TexCoord16 at = mesh.texcoords[corner], start = mesh.texcoords[face.a];
        IVec3 d{int32_t{p.x} - from.x, int32_t{p.y} - from.y, int32_t{p.z} - from.z};
        if constexpr (N.stretch)
            if (stretch.differs) {
                const auto scaled = [&](int32_t c, int i) { return static_cast<int32_t>(shift_right_round(multiply(c, stretch.position[i].raw), 18)); };
                d = {scaled(d.x, 0), scaled(d.y, 1), scaled(d.z, 2)};
            }
        return detail::TexturedEdge{d, int32_t{at.s} - start.s, int32_t{at.t} - start.t};
    };
    const detail::TexturedEdge b = edge_to(face.b), c = edge_to(face.c);
    const int64_t area = multiply(b.s, c.t) - multiply(c.s, b.t);
    if (area == 0) return {};
    if (area > 0) return {detail::combined(b.position, c.t, c.position, b.t), detail::combined(c.position, b.s, b.position, c.s)};
    return {detail::combined(c.position, b.t, b.position, c.t), detail::combined(b.position, c.s, c.position, b.s)};
}

namespace detail {
SHADE16_INLINE constexpr IVec3 as_q26(const Normal14& n) { return {int32_t{n.x.raw} * 4096, int32_t{n.y.raw} * 4096, int32_t{n.z.raw} * 4096}; }
SHADE16_INLINE constexpr IVec3 as_q26(const Normal30& n) { return {n.x.raw >> 4, n.y.raw >> 4, n.z.raw >> 4}; }
}  // namespace detail

/// A unit normal turned by a relief: n + along_s * slope.s + along_t * slope.t, normalised. Slopes have `bits` fraction bits, 19 to
/// 26, and are at most 8. A zero normal stays zero.
template <PrecisionTier Tier>
constexpr UnitVector<Tier> turned(const UnitVector<Tier>& normal, const FaceTangents& face, int32_t slope_s, int32_t slope_t, int bits) {
    const IVec3 n = detail::as_q26(normal);
    if ((n.x | n.y | n.z) == 0) return normal;
    const auto component = [&](int32_t c, Q30 s, Q30 t) {
        return saturate(c + ((multiply(s.raw, slope_s) + multiply(t.raw, slope_t)) >> (bits + 4)));
    };
    return UnitVectorOf<Tier>::normalize({component(n.x, face.along_s.x, face.along_t.x), component(n.y, face.along_s.y, face.along_t.y),
                                          component(n.z, face.along_s.z, face.along_t.z)});
}

}  // namespace shade16
