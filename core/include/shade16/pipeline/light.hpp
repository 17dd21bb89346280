// Stage 3b, light: ambient + diffuse + specular at one point of one object.
#pragma once

#include "shade16/pipeline/chord.hpp"
#include "shade16/pipeline/lamp.hpp"

namespace shade16 {

/// A point on the surface: the mean of `count` lattice positions, 1 for a vertex and 3 for a face's centre. Kept as a sum, so
/// that the centre is exact: a direction does not care about its length. A pixel counts fractions of the lattice: 4, and in
/// highp 8192.
struct SurfacePoint {
    IVec3 sum{};
    int32_t count = 1;
};

/// What the products and sums of light add to the errors of N.L and of the power, which the rest of the promise is for. In units of
/// 2^-32, for one light at intensity 1 or less; of a stronger one times the next power of two. Proved in tests/proof for three channels.
template <PrecisionTier Tier>
inline constexpr uint32_t light_term_max_error = Arithmetic<Tier>::wide ? 262 : 33'029;  // of diffuse or specular light alone
template <PrecisionTier Tier>
inline constexpr uint32_t color_sum_max_error = 2 * light_term_max_error<Tier> + 512 + (Arithmetic<Tier>::wide ? 0 : 65'536);

namespace detail {
/// The vector from a surface point to another point, of any length.
SHADE16_INLINE constexpr IVec3 towards(const LatticePoint& point, const SurfacePoint& surface, bool stretched, const Stretch& stretch) {
    const auto at = [&](int32_t c, Q30 factor) {
        if (stretched) return scale_by_power_of_two(multiply(c, factor.raw), point.bits - 30);
        return point.bits >= 0 ? shift_left(c, point.bits) : scale_by_power_of_two(c, point.bits);
    };
    const IVec3 p = surface.sum;
    const int32_t n = surface.count;
    return {n * point.position.x - at(p.x, stretch.position[0]), n * point.position.y - at(p.y, stretch.position[1]),
            n * point.position.z - at(p.z, stretch.position[2])};
}

/// The same for a pixel in highp, whose sum has 13 bits more than a lattice position; v is to be taken times 2^coarser.
struct FineVector {
    IVec3 v{};
    int coarser = 0;
};
SHADE16_ONCE constexpr FineVector towards_finely(const LatticePoint& point, const SurfacePoint& surface, bool stretched, const Stretch& stretch) {
    const auto component = [&](int32_t to, int32_t from, Q30 factor) {
        const int64_t scaled = multiply(from, stretched ? factor.raw : int32_t{Q30::one});  // 30 fraction bits more
        return int64_t{to} * surface.count - shift_right_round(scaled, min(30 - point.bits, 63));
    };
    const IVec3 p = surface.sum;
    const int64_t x = component(point.position.x, p.x, stretch.position[0]), y = component(point.position.y, p.y, stretch.position[1]),
                  z = component(point.position.z, p.z, stretch.position[2]);
    const int excess = max(0, 34 - leading_zeros(magnitude(x) | magnitude(y) | magnitude(z)));
    return {{static_cast<int32_t>(x >> excess), static_cast<int32_t>(y >> excess), static_cast<int32_t>(z >> excess)}, excess};
}

/// Whichever the point needs.
template <Needs N, bool Wide>
SHADE16_INLINE constexpr FineVector vector_to(const LatticePoint& point, const SurfacePoint& surface, bool stretched, const Stretch& stretch) {
    if constexpr (N.phong && Wide)
        if (surface.count > 3) return towards_finely(point, surface, stretched, stretch);
    return {towards(point, surface, stretched, stretch), 0};
}

inline constexpr int cosine_max_error = 1;  // unit, rounded down

/// N.L as the factor of a product: Q16 from 16-bit vectors, Q32 from 32-bit ones, up to the last value below 1.
/// Range   unit vectors; 0 for light from behind.  Error  cosine_max_error, beyond what the vectors err by.
/// Cost    a dot and a shift.  Source  Lambert's law.
SHADE16_INLINE constexpr uint32_t cosine(const Normal14& a, const Normal14& b) {
    const int32_t d = dot(a, b);
    return d <= 0 ? 0 : min<uint32_t>(static_cast<uint32_t>(d) >> 12, 65535);
}
SHADE16_INLINE constexpr uint32_t cosine(const Normal30& a, const Normal30& b) {
    const int64_t d = dot(a, b);
    return d <= 0 ? 0 : static_cast<uint32_t>(min<uint64_t>(static_cast<uint64_t>(d) >> 28, UINT32_MAX));
}

SHADE16_INLINE constexpr bool is_zero(const Normal14& v) { return (v.x.raw | v.y.raw | v.z.raw) == 0; }
SHADE16_INLINE constexpr bool is_zero(const Normal30& v) { return (v.x.raw | v.y.raw | v.z.raw) == 0; }

SHADE16_INLINE constexpr Normal14 half_of(const Normal14& l, const Normal14& v, int bits) {
    const IVec3 sum{int32_t{l.x.raw} + v.x.raw, int32_t{l.y.raw} + v.y.raw, int32_t{l.z.raw} + v.z.raw};
    return bits == 6 ? normalize14<6>(sum) : normalize14<7>(sum);
}
SHADE16_INLINE constexpr Normal30 half_of(const Normal30& l, const Normal30& v, int) { return half_vector(l, v); }

/// sum += product * factor * 2^exponent: one term of the light.
/// Range   any; saturates at 255.99.  Error  light_term_max_error for a light at intensity 1.
/// Cost    a multiply, a shift and an addition a channel.  Source  light times material, folded once an object.
template <bool Wide, Channels C>
SHADE16_INLINE constexpr void add_term(AccumulatorOf<C>& sum, const LightProductOf<C>& p, uint32_t factor, int exponent) {
    const int shift = 8 - p.exponent - exponent;
    const auto term = [&](uint32_t m) { return scaled_term(Wide ? mulhi(m, factor) : m * factor, shift); };
    for_each_channel<C>([&](uint32_t& s, uint32_t m) { shade16::accumulate(s, term(m)); }, sum, p);
}

/// A factor of add_term times an attenuation's mantissa; the exponent goes along apart.
/// Range   any.  Error  a unit of the factor, rounded down.  Cost  a high word.  Source  a product of fractions.
template <bool Wide>
SHADE16_INLINE constexpr uint32_t attenuated(uint32_t factor, Scaled attenuation) {
    return Wide ? mulhi(factor, attenuation.mantissa) : mulhi(factor << 16, attenuation.mantissa) >> 16;
}

/// The squared length of a vector that `towards` gave.
SHADE16_INLINE constexpr Scaled squared_distance(IVec3 v, int coarser, int32_t count) {
    const uint64_t squared = static_cast<uint64_t>(multiply(v.x, v.x)) + static_cast<uint64_t>(multiply(v.y, v.y)) + static_cast<uint64_t>(multiply(v.z, v.z));
    constexpr Scaled ninth{0xE38E38E4u, -3};
    if (count == 3) return Scaled::normalized(squared, 0) * ninth;
    const int count_log2 = 31 - leading_zeros(static_cast<uint32_t>(count));
    return Scaled::normalized(squared, 2 * (coarser - count_log2));
}

/// The attenuation at its end.
/// Range   any distance; 0 gives the constant term alone.  Error  attenuation_max_error.
/// Cost    a square root, two products and a reciprocal of Scaled numbers.  Source  1 / (c + l d + q d^2), as OpenGL 1 has it.
SHADE16_ONCE constexpr Scaled attenuation_along(const LatticeAttenuation& a, IVec3 v, int coarser, int32_t count) {
    return a.at(squared_distance(v, coarser, count));
}

/// A lamp's shape at its end. Range, Error, Cost, Source: lamp_factor.
template <Needs N>
SHADE16_ONCE constexpr Scaled shape_along(const LampShape& shape, IVec3 v, int coarser, int32_t count) {
    return lamp_factor<N>(shape, v, N.range || N.falloff ? squared_distance(v, coarser, count) : Scaled{});
}
constexpr bool fades_lamps(Needs n) { return n.attenuation || shapes_lamps(n); }

/// In a grey pipeline a factor is the luma of its colour: the luma of light times material, times that of the vertex and of the texel.
template <Channels C>
SHADE16_INLINE constexpr void modulate(AccumulatorOf<C>& sum, const FactorIn<C>& c) {
    for_each_channel<C>([](uint32_t& s, uint32_t factor) { s = mulhi(s, factor); }, sum, c);
}
template <Channels C>
SHADE16_INLINE constexpr void accumulate(AccumulatorOf<C>& sum, const AccumulatorOf<C>& more) {
    for_each_channel<C>([](uint32_t& s, uint32_t m) { shade16::accumulate(s, m); }, sum, more);
}

SHADE16_INLINE constexpr ColorFactor product(const ColorFactor& a, const ColorFactor& b) { return {mulhi(a.r, b.r), mulhi(a.g, b.g), mulhi(a.b, b.b)}; }
SHADE16_INLINE constexpr Luma product(const Luma& a, const Luma& b) { return {mulhi(a.luma, b.luma)}; }

/// Vertex colours and textures are a factor of ambient and diffuse light, but not of specular light.
constexpr bool has_factors(Needs n) { return n.vertex_colors || n.texture; }
}  // namespace detail

/// A point's light in two sums, before any factor.
template <Channels C>
struct SplitLightOf {
    AccumulatorOf<C> body{};   // ambient, emissive and diffuse: what vertex colours and textures multiply
    AccumulatorOf<C> shine{};  // specular
};

/// Adds the light of every lamp at a point: diffuse to `sum`, specular to `shine`, which may be the same.
template <Needs N, PrecisionTier Tier>
SHADE16_INLINE constexpr void add_lights(AccumulatorOf<channels_of<Tier>>& sum, AccumulatorOf<channels_of<Tier>>& shine, const ObjectLighting<Tier>& object, View<ObjectLight<Tier>> lights,
                                         const Shininess<Tier>* shininess, const SurfacePoint& position, UnitVector<Tier> normal) {
    constexpr bool wide = Arithmetic<Tier>::wide;
    const bool stretched = N.stretch && object.stretch.differs;

    UnitVector<Tier> view = object.view;
    const bool local_viewer = N.local_viewer && object.local_viewer && shininess != nullptr;
    if constexpr (N.local_viewer)
        if (local_viewer) view = UnitVectorOf<Tier>::normalize(detail::vector_to<N, wide>(object.eye, position, stretched, object.stretch).v);

    for (const ObjectLight<Tier>& light : lights) {
        UnitVector<Tier> direction = light.direction;
        const bool is_point = N.point && (!N.directional || light.is_point);
        detail::FineVector to_light{};
        if constexpr (N.point)
            if (is_point) {
                to_light = detail::vector_to<N, wide>(light.point, position, stretched, object.stretch);
                direction = UnitVectorOf<Tier>::normalize(to_light.v);
            }

        uint32_t n_dot_l = detail::cosine(normal, direction);
        if (n_dot_l == 0) continue;
        Scaled fading{};
        bool fades = N.attenuation && is_point && light.attenuation.fades;
        if constexpr (N.attenuation)
            if (fades) fading = detail::attenuation_along(light.attenuation, to_light.v, to_light.coarser, position.count);
        if constexpr (detail::shapes_lamps(N))
            if (is_point && light.shape != 0) {
                const Scaled shaped = detail::shape_along<N>(object.shapes[light.shape - 1], to_light.v, to_light.coarser, position.count);
                if (shaped.is_zero()) continue;
                fading = fades ? fading * shaped : shaped;
                fades = true;
            }
        if constexpr (detail::fades_lamps(N))
            if (fades) n_dot_l = detail::attenuated<wide>(n_dot_l, fading);
        if constexpr (N.diffuse) detail::add_term<wide>(sum, light.diffuse, n_dot_l, fading.exponent);
        if constexpr (N.specular) {
            if (shininess == nullptr) continue;
            const bool reflects = N.reflected && (!N.halfway || object.reflects);
            uint32_t u = 0;
            if constexpr (N.reflected)
                if (reflects) {
                    if (local_viewer && detail::is_zero(view)) continue;
                    u = detail::reflected_chord(normal, direction, view);
                }
            if (!reflects) {
                UnitVector<Tier> half = light.half;
                if (is_point || local_viewer) half = detail::half_of(direction, view, Arithmetic<Tier>::rsqrt_bits);
                if (detail::is_zero(half) || (local_viewer && detail::is_zero(view))) continue;
                u = detail::chord(normal, half);
            }
            uint32_t power = shininess->power(u);
            if constexpr (detail::fades_lamps(N))
                if (fades) power = detail::attenuated<wide>(power, fading);
            if (power != 0) detail::add_term<wide>(shine, light.specular, power, fading.exponent);
        }
    }
}

/// The lit colour of a point.
/// Range   any position on the lattice, any unit normal (a zero one gives no diffuse and no specular light).
/// Error   Tier::promise for each light arriving at intensity 1, added up, under the conditions stated there.
/// Cost    for each light a dot, a chord, two table reads and eight multiplies; a point light or a local viewer adds a
///         normalisation, attenuation a square root and a reciprocal.
/// Source  Blinn, Models of Light Reflection for Computer Synthesized Pictures, 1977.
template <Needs N, PrecisionTier Tier>
SHADE16_INLINE constexpr AccumulatorOf<channels_of<Tier>> light_point(const ObjectLighting<Tier>& object, View<ObjectLight<Tier>> lights, const Shininess<Tier>* shininess,
                                                 const SurfacePoint& position, UnitVector<Tier> normal, const FactorIn<channels_of<Tier>>* factor) {
    AccumulatorOf<channels_of<Tier>> sum = object.base, apart{};
    add_lights<N>(sum, detail::has_factors(N) ? apart : sum, object, lights, shininess, position, normal);
    if constexpr (detail::has_factors(N)) {
        if (factor != nullptr) detail::modulate(sum, *factor);
        if constexpr (N.specular) detail::accumulate(sum, apart);
    }
    return sum;
}

/// The same light before any factor, for surfaces whose texture comes pixel by pixel.
template <Needs N, PrecisionTier Tier>
constexpr SplitLightOf<channels_of<Tier>> split_light_point(const ObjectLighting<Tier>& object, View<ObjectLight<Tier>> lights, const Shininess<Tier>* shininess,
                                       const SurfacePoint& position, UnitVector<Tier> normal, const FactorIn<channels_of<Tier>>* factor) {
    SplitLightOf<channels_of<Tier>> light{object.base, {}};
    add_lights<N>(light.body, light.shine, object, lights, shininess, position, normal);
    if constexpr (N.vertex_colors)
        if (factor != nullptr) detail::modulate(light.body, *factor);
    return light;
}

/// A stored normal as the tier lights it: as it is in the 16-bit tiers, renormalised in highp and under a stretch.
template <Needs N, PrecisionTier Tier>
SHADE16_INLINE constexpr UnitVector<Tier> lighting_normal(const ObjectLighting<Tier>& object, const Normal14& stored) {
    if constexpr (N.stretch)
        if (object.stretch.differs) {
            const auto component = [&](Unit14 c, int i) { return static_cast<int32_t>(multiply(c.raw, object.stretch.normal[i].raw) >> 16); };
            return UnitVectorOf<Tier>::normalize({component(stored.x, 0), component(stored.y, 1), component(stored.z, 2)});
        }
    if constexpr (Arithmetic<Tier>::wide) return normalize30(raw(stored));
    else return stored;
}

}  // namespace shade16
