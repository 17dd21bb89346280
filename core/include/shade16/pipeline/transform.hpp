// Stage 1, transform: from the mesh's lattice to the screen.
#pragma once

#include "shade16/num/block.hpp"
#include "shade16/pipeline/vertex.hpp"
#include "shade16/scene/needs.hpp"

namespace shade16 {

struct Viewport {
    int32_t width = 0, height = 0;  // 1 to 2048 pixels
};

/// The guard band's half width, in 1/16 pixel from the centre: a little inside 16 bits, so that rounding stays inside too.
inline constexpr int32_t guard_extent = 32760;
/// Depth values keep a few units clear of both ends: stepping may err by one or two, and must not wrap.
inline constexpr uint32_t first_depth = 4, last_depth = 65530;

/// A vertex before the divide. Units are 2^unit of the object's ViewTransform. x and y are scaled so that the guard band
/// is |x| <= w, |y| <= w; `depth` is the distance along the camera's axis.
struct ClipVertex {
    int32_t x = 0, y = 0, w = 0, depth = 0;
};

/// Everything that takes one object's lattice to the screen, made once a frame. The three rows give x, y and depth; all
/// share one unit, chosen so that nothing overflows for any position on the lattice.
struct ViewTransform {
    int32_t row[3][3]{};   // below 2^28, in 2^-16 of the unit
    int32_t offset[3]{};   // below 2^29
    int32_t near_depth = 0;
    int32_t orthographic_w = 0;  // 0 in perspective, where w is the depth
    uint32_t depth_scale = 0;    // mantissa and shift of what takes a depth fraction to [0, last_depth]
    int8_t depth_shift = 0;

    template <Needs N = all_needs>
    constexpr bool is_perspective() const { return N.perspective && (!N.orthographic || orthographic_w == 0); }
};

/// The camera with what follows from it, made once a frame.
struct View3 {
    Mat3 rotation{};
    BlockVector eye{};
    Scaled focal_over_guard{};  // pixels a unit of slope (perspective) or of length, over the guard band's pixels
    Block near_distance{}, depth_range{};
    bool perspective = true;
};

namespace detail {
/// cot(fov / 2) * height / 2 or height / view_height: the focal length in pixels.
constexpr Scaled focal_px(const Camera& camera, int32_t height) {
    const Scaled rows = Scaled::normalized(static_cast<uint64_t>(height), 0);
    if (camera.projection == Projection::orthographic)
        return rows * reciprocal(Scaled::normalized(magnitude(max(camera.view_height.raw, int32_t{1})), -16));
    const SinCos half = sincos(camera.fov_y.half());
    const auto scaled = [](Q30 v) { return Scaled::normalized(magnitude(max(v.raw, int32_t{1})), -31); };  // -31: half the height
    return rows * scaled(half.cos) * reciprocal(scaled(half.sin)) * Scaled{0x80000000u, 0};
}
}  // namespace detail

constexpr View3 make_view(const Camera& camera, Viewport viewport) {
    View3 view;
    view.rotation = look_rotation(camera);
    view.eye = as_block(camera.eye);
    view.perspective = camera.projection == Projection::perspective;
    view.near_distance = {max(camera.near_distance.raw, int32_t{1}), -16};
    view.depth_range = {max<int64_t>(int64_t{camera.far_distance.raw} - view.near_distance.mantissa, 1), -16};
    const Scaled guard_px = Scaled::normalized(guard_extent, -4);
    view.focal_over_guard = detail::focal_px(camera, viewport.height) * reciprocal(guard_px);
    return view;
}

constexpr ViewTransform make_view_transform(const View3& view, const Pose& pose, const Mesh& mesh) {
    const Mat3 turn = view.rotation * pose.rotation;
    const BlockVector centre = pose.rotation * component_product(pose.scale, mesh.centre) + as_block(pose.translation);
    BlockVector offset = view.rotation * (centre - view.eye);

    // The rows: right, down and forward, each entry a Q46 times the lattice's own step.
    const Q16 scale[3] = {pose.scale.x, pose.scale.y, pose.scale.z};
    const auto entry = [&](int i, int j) {
        const Normal30& r = turn.row[i];
        return Block{multiply(j == 0 ? r.x.raw : j == 1 ? r.y.raw : r.z.raw, scale[j].raw), -46 - mesh.fraction_bits};
    };
    Scaled focal = view.focal_over_guard;
    Block w_orthographic{};
    if (!view.perspective) {  // w is the depth range, so that depth over w runs from 0 to 1
        w_orthographic = view.depth_range;
        focal = focal * Scaled::normalized(static_cast<uint64_t>(view.depth_range.mantissa), -16);
    }
    Block rows[3][3];
    for (int j = 0; j < 3; ++j) {
        rows[0][j] = entry(0, j) * focal;
        rows[1][j] = -(entry(1, j) * focal);
        rows[2][j] = -entry(2, j);
    }
    const Block offsets[3] = {offset.x * focal, -(offset.y * focal), -offset.z};

    int32_t unit = max(w_orthographic.top(), view.near_distance.top() - 1) - 29;
    for (int i = 0; i < 3; ++i) {
        unit = max(unit, offsets[i].top() - 29);
        for (int j = 0; j < 3; ++j) unit = max(unit, rows[i][j].top() - 12);
    }
    ViewTransform t;
    for (int i = 0; i < 3; ++i) {
        t.offset[i] = offsets[i].in_units_of(unit);
        for (int j = 0; j < 3; ++j) t.row[i][j] = rows[i][j].in_units_of(unit - 16);
    }
    t.near_depth = max(view.near_distance.in_units_of(unit), int32_t{1});
    t.orthographic_w = w_orthographic.mantissa == 0 ? 0 : max(w_orthographic.in_units_of(unit), int32_t{1});

    // Perspective depth is far/(far-near) * (1 - near/w); orthographic depth is linear.
    Scaled depth_scale = Scaled::normalized(last_depth, 0);
    if (view.perspective) {
        const Scaled range = Scaled::normalized(static_cast<uint64_t>(view.depth_range.mantissa), -16);
        const Scaled far_distance = Scaled::normalized(static_cast<uint64_t>(view.near_distance.mantissa + view.depth_range.mantissa), -16);
        depth_scale = depth_scale * far_distance * reciprocal(range);
    }
    t.depth_scale = depth_scale.mantissa;
    t.depth_shift = static_cast<int8_t>(clamp(30 - depth_scale.exponent, 0, 31));
    return t;
}

namespace detail {
/// offset + floor((r . p) / 2^16). Wide and narrow multipliers need different bodies; the split at 14 bits is exact.
SHADE16_INLINE constexpr int32_t row_dot(const int32_t (&r)[3], Position16 p, int32_t offset) {
#if SHADE16_NARROW_MULTIPLY
    const int32_t high = (r[0] >> 14) * p.x + (r[1] >> 14) * p.y + (r[2] >> 14) * p.z;
    const int32_t low = (r[0] & 0x3FFF) * p.x + (r[1] & 0x3FFF) * p.y + (r[2] & 0x3FFF) * p.z;
    return offset + ((high + (low >> 14)) >> 2);
#else
    const int64_t sum = static_cast<int64_t>(static_cast<uint64_t>(static_cast<uint32_t>(offset)) << 32);
    return static_cast<int32_t>((sum + multiply(r[0], int32_t{p.x} * 65536) + multiply(r[1], int32_t{p.y} * 65536) + multiply(r[2], int32_t{p.z} * 65536)) >> 32);
#endif
}
}  // namespace detail

template <Needs N = all_needs>
SHADE16_INLINE constexpr ClipVertex to_clip(const ViewTransform& t, Position16 p) {
    ClipVertex v;
    v.x = detail::row_dot(t.row[0], p, t.offset[0]);
    v.y = detail::row_dot(t.row[1], p, t.offset[1]);
    v.depth = detail::row_dot(t.row[2], p, t.offset[2]);
    v.w = t.is_perspective<N>() ? v.depth : t.orthographic_w;
    return v;
}

/// Inside the guard band and beyond the near plane: it can be projected. No distance overflows, so one sign tells.
SHADE16_INLINE constexpr bool is_inside(const ViewTransform& t, const ClipVertex& v) {
    return ((v.w + v.x) | (v.w - v.x) | (v.w + v.y) | (v.w - v.y) | (v.depth - t.near_depth)) >= 0;
}

constexpr uint16_t outcode(const ViewTransform& t, const ClipVertex& v) {
    uint32_t code = 0;
    if (v.depth < t.near_depth) code |= outside_near;
    if (v.x < -v.w) code |= outside_left;
    if (v.x > v.w) code |= outside_right;
    if (v.y < -v.w) code |= outside_top;
    if (v.y > v.w) code |= outside_bottom;
    return static_cast<uint16_t>(code);
}
/// For the few that are outside, apart from the loop over all vertices.
SHADE16_ONCE constexpr uint16_t outcode(const ViewTransform& t, const Position16& p) { return outcode(t, to_clip(t, p)); }

/// The divide: screen position and depth of a vertex inside the guard band and beyond the near plane.
/// Error   1 sub-pixel and 2 of 65536 in depth where w is at least 2^19 units (0.62 and 1.05 measured); nearer than
///         that, where a near plane is tiny against the scene, 4.5 * 32760 / w sub-pixels more.
/// Cost    one reciprocal and four high multiplies.
template <Needs N = all_needs, PrecisionTier Tier>
SHADE16_INLINE constexpr void project(const ViewTransform& t, const ClipVertex& v, ScreenVertex<Tier>& out) {
    const int shift = leading_zeros(static_cast<uint32_t>(v.w));
    const uint32_t r = reciprocal_of_normalized(static_cast<uint32_t>(v.w) << shift);
    const int32_t k = static_cast<int32_t>(mulhi(r, static_cast<uint32_t>(guard_extent) << 16));
    out.x = static_cast<int16_t>(shift_right_round(mulhi(shift_left(v.x, shift - 1), k), 14));
    out.y = static_cast<int16_t>(shift_right_round(mulhi(shift_left(v.y, shift - 1), k), 14));

    const auto over_w = [&](int32_t n) { return mulhi(static_cast<uint32_t>(n) << (shift - 1), r); };  // Q30, for n <= w
    constexpr uint32_t one = uint32_t{1} << 30;
    const uint32_t fraction = t.is_perspective<N>() ? one - min(over_w(t.near_depth), one)
                                                 : over_w(min(v.depth - t.near_depth, v.w));
    out.z = static_cast<uint16_t>(clamp(mulhi(fraction, t.depth_scale) >> t.depth_shift, first_depth, last_depth));
}

}  // namespace shade16
