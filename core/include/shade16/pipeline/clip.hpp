// Stage 2, clip: against the near plane and the guard band. Triangles that only cross the frame's edges are not clipped:
// the raster stage skips the pixels.
#pragma once

#include "shade16/num/reciprocal.hpp"
#include "shade16/pipeline/transform.hpp"

namespace shade16 {

/// A corner of the polygon that clipping makes. In a grey pipeline `r` is its luma; Phong shading needs all three anyway.
template <PrecisionTier Tier>
struct ClipCorner {
    ClipVertex position;
    typename ScreenVertex<Tier>::Channel r = 0, g = 0, b = 0;
};

/// A convex polygon. A triangle gains at most one corner a plane.
template <PrecisionTier Tier>
struct ClipPolygon {
    static constexpr int max_corners = 3 + 5;
    ClipCorner<Tier> corner[max_corners];
    int count = 0;

    constexpr void add(const ClipCorner<Tier>& c) {
        if (count < max_corners) corner[count++] = c;
    }
};

namespace detail {
/// How far inside a plane a vertex is; negative outside.
constexpr int32_t distance_inside(const ViewTransform& t, const ClipVertex& v, Outcode plane) {
    switch (plane) {
        case outside_near: return v.depth - t.near_depth;
        case outside_left: return v.w + v.x;
        case outside_right: return v.w - v.x;
        case outside_top: return v.w + v.y;
        default: return v.w - v.y;
    }
}

/// a / (a + b) as Q31, for a, b >= 0 and not both 0.
constexpr uint32_t crossing(uint32_t a, uint32_t b) {
    const uint32_t sum = a + b;
    const int shift = leading_zeros(sum);
    return mulhi(a << shift, reciprocal_of_normalized(sum << shift));
}

constexpr int32_t mix(int32_t from, int32_t to, uint32_t t) {
    return from + static_cast<int32_t>(shift_right_round(multiply(to - from, t), 31));
}

/// Where the edge from an inner to an outer corner meets the plane. Always computed from the inner end, so that two
/// triangles that share the edge find the same point; the plane's own coordinate is exact.
template <PrecisionTier Tier>
constexpr ClipCorner<Tier> meet(const ViewTransform& t, const ClipCorner<Tier>& in, const ClipCorner<Tier>& out, Outcode plane) {
    const int32_t a = distance_inside(t, in.position, plane), b = distance_inside(t, out.position, plane);
    const uint32_t k = crossing(static_cast<uint32_t>(a), magnitude(b));
    const auto channel = [k](auto from, auto to) {
        return static_cast<decltype(from)>(mix(static_cast<int32_t>(from), static_cast<int32_t>(to), k));
    };
    ClipCorner<Tier> c;
    c.position.depth = mix(in.position.depth, out.position.depth, k);
    if (plane == outside_near) c.position.depth = t.near_depth;
    c.position.w = t.is_perspective() ? max(c.position.depth, t.near_depth) : t.orthographic_w;
    c.position.x = mix(in.position.x, out.position.x, k);
    c.position.y = mix(in.position.y, out.position.y, k);
    if (plane == outside_left) c.position.x = -c.position.w;
    if (plane == outside_right) c.position.x = c.position.w;
    if (plane == outside_top) c.position.y = -c.position.w;
    if (plane == outside_bottom) c.position.y = c.position.w;
    c.r = channel(in.r, out.r), c.g = channel(in.g, out.g), c.b = channel(in.b, out.b);
    return c;
}
}  // namespace detail

/// The part of the polygon inside one plane.
/// Source  Sutherland and Hodgman, Reentrant Polygon Clipping, 1974.
template <PrecisionTier Tier>
constexpr ClipPolygon<Tier> clip(const ViewTransform& t, const ClipPolygon<Tier>& polygon, Outcode plane) {
    ClipPolygon<Tier> result;
    for (int i = 0; i < polygon.count; ++i) {
        const ClipCorner<Tier>& from = polygon.corner[i];
        const ClipCorner<Tier>& to = polygon.corner[i + 1 == polygon.count ? 0 : i + 1];
        const bool from_inside = detail::distance_inside(t, from.position, plane) >= 0;
        const bool to_inside = detail::distance_inside(t, to.position, plane) >= 0;
        if (from_inside) result.add(from);
        if (from_inside && !to_inside) result.add(detail::meet(t, from, to, plane));
        if (!from_inside && to_inside) result.add(detail::meet(t, to, from, plane));
    }
    return result;
}

/// The part of the polygon that can be projected: beyond the near plane and inside the guard band.
template <PrecisionTier Tier>
constexpr ClipPolygon<Tier> clip(const ViewTransform& t, ClipPolygon<Tier> polygon) {
    constexpr Outcode planes[] = {outside_near, outside_left, outside_right, outside_top, outside_bottom};
    for (const Outcode plane : planes)
        polygon = clip(t, polygon, plane);
    return polygon;
}

}  // namespace shade16
