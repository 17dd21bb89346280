// The normal-to-colour table: with lights at infinity and an infinite viewer all light is one function of the normal, tabulated
// in the view's frame, where it stays while an object turns. A policy of the material, with a bound of its own: it is far from
// what any tier promises, and never stands for one.
#pragma once

#include "shade16/pipeline/light.hpp"

namespace shade16 {

inline constexpr int light_table_log2 = 6;
inline constexpr int32_t light_table_side = int32_t{1} << light_table_log2;
inline constexpr uint32_t light_table_entries = uint32_t{1} << (2 * light_table_log2);

/// |N.L| below which a highlight may begin or end too early: an entry spans up to 6 degrees.
inline constexpr uint32_t light_table_gate_per_1024 = 113;

/// The largest error for one light arriving at intensity 1, beside half a code of RGB565: 18 + 5.5 sqrt(n) levels for the nearest entry,
/// up to 2.9 degrees away, and 2 + 1.9 sqrt(n) + 0.07 n for four. Beside N.L = 0, within light_table_gate, a highlight may
/// begin or end too early. Between vertices it is the table's map that normals are interpolated on, and not their components.
constexpr Levels light_table_max_error(LightTable kind, Q16 exponent) {
    const auto n = static_cast<uint64_t>(clamp(exponent.raw, min_shininess.raw, max_shininess.raw));      // Q16
    const uint64_t root = isqrt(n);                                                                      // Q8
    if (kind == LightTable::nearest) return {static_cast<uint32_t>(18'000'000 + (5'500'000 * root >> 8))};
    return {static_cast<uint32_t>(2'000'000 + (1'900'000 * root >> 8) + (70'000 * n >> 16))};
}

/// Where a normal lies in the table, in 1/1024 entry.
struct TablePlace {
    uint16_t s = 0, t = 0;
};

namespace detail {
inline constexpr int table_place_bits = 10;
/// The table's half width on the map below: normals up to 106 degrees from the viewer; others are taken as if they were there.
inline constexpr int32_t table_reach = 858'993'459;  // 0.8, Q30
inline constexpr int32_t least_table_z = -300'647'711;  // 1 - 2 * 0.8^2, Q30

/// Lambert's azimuthal map of a unit vector in view coordinates: (x, y) / sqrt(2 (1 + z)), within 0.8. Every place has the same share
/// of directions, and none is steep, as (x, y) alone would be at the silhouette.
/// Error   2^-18.
SHADE16_ONCE constexpr TablePlace table_place(const Normal30& n) {
    IVec3 v = raw(n);
    if (v.z < least_table_z) {  // out to the rim, in the same direction
        const Normal30 flat = normalize30({v.x, v.y, 0});
        constexpr int32_t rim = 1'030'792'151;  // sqrt(1 - z^2) = 0.96 there
        v = {static_cast<int32_t>(multiply(flat.x.raw, rim) >> 30), static_cast<int32_t>(multiply(flat.y.raw, rim) >> 30), least_table_z};
    }
    const Scaled root = sqrt(Scaled::normalized(static_cast<uint64_t>(int64_t{Q30::one} + v.z), -29));  // sqrt(2 (1 + z))
    const auto per_entry = static_cast<uint32_t>((reciprocal(root) * Scaled::normalized(5, -3)).to_fixed(31));  // 1 / (2 * 0.8), Q31
    const auto coordinate = [per_entry](int32_t c) {
        const int32_t q16 = static_cast<int32_t>(multiply(c, per_entry) >> (61 - light_table_log2 - table_place_bits));
        return static_cast<uint16_t>(clamp<int32_t>(q16 + 32768, 0, 65535));
    };
    return {coordinate(v.x), coordinate(v.y)};
}

/// The normal that an entry stands for, that in its middle; beyond the map's reach the nearest one on its rim. Q29, of any length.
SHADE16_ONCE constexpr IVec3 table_normal(int32_t column, int32_t row) {
    const auto coordinate = [](int32_t i) { return static_cast<int32_t>(multiply(table_reach, 2 * i + 1 - light_table_side) >> light_table_log2); };
    int32_t x = coordinate(column), y = coordinate(row);
    uint64_t squared = static_cast<uint64_t>(multiply(x, x) + multiply(y, y));  // Q60
    const uint64_t most = static_cast<uint64_t>(multiply(table_reach, table_reach));
    if (squared > most) {
        const Normal30 outward = normalize30({x, y, 0});
        x = static_cast<int32_t>(multiply(outward.x.raw, table_reach) >> 30), y = static_cast<int32_t>(multiply(outward.y.raw, table_reach) >> 30);
        squared = most;
    }
    // (2 x sqrt(1 - p^2), 2 y sqrt(1 - p^2), 1 - 2 p^2), halved.
    const auto root = static_cast<uint32_t>(sqrt(Scaled::normalized((uint64_t{1} << 60) - squared, -60)).to_fixed(30));
    const auto halved = [root](int32_t c) { return static_cast<int32_t>(multiply(c, root) >> 30); };
    return {halved(x), halved(y), static_cast<int32_t>(((int64_t{1} << 60) - 2 * static_cast<int64_t>(squared)) >> 31)};
}
}  // namespace detail

/// One object's table and what it was made of, so that it is made anew only when that changes.
template <PrecisionTier Tier>
struct LightTableMemory {
    static constexpr Channels channels = channels_of<Tier>;

    ObjectLighting<Tier> lighting{};  // in the view's frame
    const Shininess<Tier>* shininess = nullptr;
    uint32_t lights = 0;
    bool is_made = false;
    Mat3 to_view{{{}, {}, {}}};               // from the object's frame of lighting; all zero, lest the memory lie in flash, too
    uint16_t entry[light_table_entries]{};    // RGB565, or a luma of 16 bits
};

namespace detail {
template <Channels C>
constexpr uint16_t table_entry(const AccumulatorOf<C>& light) {
    const auto code = [](uint32_t c, uint32_t largest) { return (min(c, Accumulator::one) * largest + (uint32_t{1} << 23)) >> 24; };
    if constexpr (C == Channels::luma) return static_cast<uint16_t>(min(light.luma >> 8, uint32_t{65535}));
    else return static_cast<uint16_t>(code(light.r, 31) << 11 | code(light.g, 63) << 5 | code(light.b, 31));
}

/// Makes all entries. Cost: the light of 4096 points.
template <Needs N, PrecisionTier Tier>
[[gnu::noinline]] constexpr void fill_light_table(LightTableMemory<Tier>& table, View<ObjectLight<Tier>> lights) {
    for (int32_t row = 0, i = 0; row < light_table_side; ++row)
        for (int32_t column = 0; column < light_table_side; ++column, ++i)
            table.entry[i] = table_entry<channels_of<Tier>>(
                light_point<N>(table.lighting, lights, table.shininess, {}, UnitVectorOf<Tier>::normalize(table_normal(column, row)), nullptr));
}

template <Channels C, class T>
constexpr bool is_same_color(const T& a, const T& b) {
    bool same = true;
    for_each_channel<C>([&same](uint32_t p, uint32_t q) { same = same && p == q; }, a, b);
    return same;
}
template <PrecisionTier Tier>
constexpr bool is_same(const ObjectLighting<Tier>& a, const ObjectLighting<Tier>& b) {
    return a.reflects == b.reflects && a.view == b.view && is_same_color<channels_of<Tier>>(a.base, b.base);
}
template <PrecisionTier Tier>
constexpr bool is_same(const ObjectLight<Tier>& a, const ObjectLight<Tier>& b) {
    constexpr Channels C = channels_of<Tier>;
    return a.direction == b.direction && a.half == b.half && a.diffuse.exponent == b.diffuse.exponent && a.specular.exponent == b.specular.exponent &&
           is_same_color<C>(a.diffuse, b.diffuse) && is_same_color<C>(a.specular, b.specular);
}

/// The scene's lights in the view's frame; false where one of them is a lamp. `to` has room for all of them.
template <Needs N, PrecisionTier Tier>
constexpr bool lights_in_view(ObjectLight<Tier>* to, uint32_t& count, const Camera& camera, const Mat3& view_rotation, View<Light> lights,
                              const Material& material, const Pose& pose, Component shown) {
    const Pose at_view{transpose(view_rotation), {1, 1, 1}, {}};
    count = 0;
    for (Light light : lights) {
        if (light.kind == LightKind::ambient || light.intensity.is_zero()) continue;
        if (light.is_lamp()) return false;
        if (light.space == Space::object) light.position = pose.rotation * light.position, light.space = Space::world;
        to[count] = make_object_light<Tier, N>(camera, view_rotation, light, material, at_view, Mesh{});
        keep_component(to[count++], shown);
    }
    return true;
}
}  // namespace detail

/// Whether an object's table holds: no lamp shines and no viewer is local. Then the table is up to date; `lights` has room for the
/// scene's lights, and keeps those that the table was made of.
template <Needs N, PrecisionTier Tier>
constexpr bool prepare_light_table(LightTableMemory<Tier>& table, ObjectLight<Tier>* kept, ObjectLight<Tier>* scratch, const Camera& camera,
                                   const Mat3& view_rotation, View<Light> lights, const Material& material, const Pose& pose, Component shown,
                                   const Shininess<Tier>* shininess) {
    uint32_t count = 0;
    if (shininess != nullptr && camera.sees_locally()) return false;
    if (!detail::lights_in_view<N, Tier>(scratch, count, camera, view_rotation, lights, material, pose, shown)) return false;
    const Pose at_view{transpose(view_rotation), {1, 1, 1}, {}};
    ObjectLighting<Tier> lighting = make_object_lighting<Tier, N>(camera, view_rotation, lights, material, at_view, Mesh{});
    lighting.local_viewer = false;  // without a highlight it does not matter
    keep_component(lighting, shown);
    table.to_view = view_rotation * pose.rotation;
    bool is_same = table.is_made && table.lights == count && table.shininess == shininess && detail::is_same(table.lighting, lighting);
    for (uint32_t i = 0; i < count; ++i) is_same = is_same && detail::is_same(kept[i], scratch[i]);
    if (is_same) return true;
    for (uint32_t i = 0; i < count; ++i) kept[i] = scratch[i];
    table.lighting = lighting, table.shininess = shininess, table.lights = count, table.is_made = true;
    detail::fill_light_table<N>(table, {kept, count});
    return true;
}

}  // namespace shade16
