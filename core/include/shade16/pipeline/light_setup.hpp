// Stage 3a: the lights as one object sees them, made once a frame, in the frame of lattice.hpp.
#pragma once

#include "shade16/num/accumulator.hpp"
#include "shade16/num/shininess.hpp"
#include "shade16/pipeline/lattice.hpp"
#include "shade16/scene/needs.hpp"

namespace shade16 {

/// The unit vectors of a tier.
template <PrecisionTier Tier>
struct UnitVectorOf {
    static constexpr bool wide = Arithmetic<Tier>::wide;
    static constexpr auto from(const Normal30& v) {
        if constexpr (wide) return v;
        else return Normal14{narrowed(v.x), narrowed(v.y), narrowed(v.z)};
    }
    static constexpr auto normalize(IVec3 v) {
        if constexpr (wide) return normalize30(v);
        else return normalize14<Arithmetic<Tier>::rsqrt_bits>(v);
    }
    using type = decltype(normalize(IVec3{}));

private:
    static constexpr Unit14 narrowed(Q30 v) { return {static_cast<int16_t>(shift_right_round(v.raw, 16))}; }
};
template <PrecisionTier Tier>
using UnitVector = typename UnitVectorOf<Tier>::type;

/// Light colour times material colour times intensity: three mantissas and one exponent, m * 2^(exponent - 16) in the
/// 16-bit tiers and m * 2^(exponent - 32) in highp.
template <Channels C>
struct LightProductOf {
    uint32_t r = 0, g = 0, b = 0;
    int16_t exponent = 0;

    constexpr bool is_zero() const { return (r | g | b) == 0; }
};
/// In a grey pipeline the luma of that product, as one mantissa.
template <>
struct LightProductOf<Channels::luma> {
    uint32_t luma = 0;
    int16_t exponent = 0;

    constexpr bool is_zero() const { return luma == 0; }
};
using LightProduct = LightProductOf<Channels::rgb>;

template <PrecisionTier Tier>
struct ObjectLight {
    bool is_point = false;
    uint16_t shape = 0;  // of a lamp with a range, a falloff or a cone: its place among the object's LampShapes, from 1
    LatticeAttenuation attenuation{};
    LatticePoint point{};          // of a point light or a spot
    UnitVector<Tier> direction{};  // of a directional one, towards the light
    UnitVector<Tier> half{};       // and, with an infinite viewer, the half vector
    LightProductOf<channels_of<Tier>> diffuse{}, specular{};
};

struct LampShape;

/// What lights one object for one frame.
template <PrecisionTier Tier>
struct ObjectLighting {
    AccumulatorOf<channels_of<Tier>> base{};  // ambient, emissive; or the colour of an unlit object
    bool local_viewer = false;
    bool reflects = false;  // by Phong's model
    LatticePoint eye{};
    UnitVector<Tier> view{};  // of an infinite viewer
    Stretch stretch{};
    const LampShape* shapes = nullptr;
};

namespace detail {
/// The luma of the product of two colours: its three products are added up exactly before anything is rounded.
template <PrecisionTier Tier>
    requires(channels_of<Tier> == Channels::luma)
SHADE16_ONCE constexpr LightProductOf<Channels::luma> make_product(Rgb material, Rgb light, Scaled intensity) {
    const auto product = [](Unorm16 m, Unorm16 l, uint32_t weight) { return multiply(uint32_t{m.raw} * l.raw, weight); };
    const uint64_t sum = product(material.r, light.r, LumaWeights::red) + product(material.g, light.g, LumaWeights::green) +
                         product(material.b, light.b, LumaWeights::blue);  // one is 65535^2 * 2^16
    const uint64_t once = sum * 65537;                                     // and becomes (2^32 - 1)^2, as with two widened colours
    const Scaled s = Scaled::normalized(once + (once >> 16), -64) * intensity;
    if (s.is_zero()) return {};
    return {static_cast<uint32_t>(shift_right_round(uint64_t{s.mantissa}, Arithmetic<Tier>::wide ? 0 : 16)), static_cast<int16_t>(s.exponent)};
}

/// Products of two 16-bit colours, with one exponent for the brightest channel.
template <PrecisionTier Tier>
SHADE16_ONCE constexpr LightProduct make_product(Rgb material, Rgb light, Scaled intensity) {
    const auto product = [&](Unorm16 m, Unorm16 l) {
        return Scaled::normalized(multiply(m.widened(), l.widened()), -64) * intensity;
    };
    const Scaled p[3] = {product(material.r, light.r), product(material.g, light.g), product(material.b, light.b)};
    int exponent = -1000;
    for (const Scaled& s : p)
        if (!s.is_zero()) exponent = max<int>(exponent, s.exponent);
    if (exponent == -1000) return {};
    const auto mantissa = [exponent](Scaled s) {
        if (s.is_zero()) return uint32_t{0};
        const int shift = min(exponent - s.exponent, 40) + (Arithmetic<Tier>::wide ? 0 : 16);
        return static_cast<uint32_t>(shift_right_round(uint64_t{s.mantissa}, shift));
    };
    return {mantissa(p[0]), mantissa(p[1]), mantissa(p[2]), static_cast<int16_t>(exponent)};
}

template <Channels C>
constexpr void add_product(AccumulatorOf<C>& sum, const LightProductOf<C>& p) {
    for_each_channel<C>([&](uint32_t& s, uint32_t m) { accumulate(s, scaled_term(m, 8 - p.exponent)); }, sum, p);
}

/// A direction of a light's space, of any length, in the frame of lighting.
constexpr Normal30 direction_in(const LightingFrame& frame, const Mat3& view_to_world, Space space, Vec3 given) {
    Normal30 direction = normalize(given);
    if (space == Space::view) direction = normalize_finely(rotate(view_to_world, raw(direction)));
    if (space != Space::object) direction = frame.direction(direction);
    return direction;
}

}  // namespace detail

/// The half vector of two unit vectors, formed in 32 bits; zero where they are opposite.
SHADE16_ONCE constexpr Normal30 half_vector(const Normal30& a, const Normal30& b) {
    return normalize30({(a.x.raw >> 1) + (b.x.raw >> 1), (a.y.raw >> 1) + (b.y.raw >> 1), (a.z.raw >> 1) + (b.z.raw >> 1)});
}

/// What a component leaves of them: set-up alone knows that there are components.
template <PrecisionTier Tier>
constexpr void keep_component(ObjectLighting<Tier>& o, Component shown) {
    if (!shows(shown, Component::ambient)) o.base = {};
}
template <PrecisionTier Tier>
constexpr void keep_component(ObjectLight<Tier>& o, Component shown) {
    if (!shows(shown, Component::diffuse)) o.diffuse = {};
    if (!shows(shown, Component::specular)) o.specular = {};
}

/// What one object keeps of the scene's ambient light, viewer and scale.
template <PrecisionTier Tier, Needs N = all_needs>
constexpr ObjectLighting<Tier> make_object_lighting(const Camera& camera, const Mat3& view_rotation, View<Light> lights,
                                                    const Material& material, const Pose& pose, const Mesh& mesh) {
    const detail::LightingFrame frame(pose, mesh);
    ObjectLighting<Tier> o;
    if constexpr (N.stretch) o.stretch = detail::make_stretch(pose.scale);
    if (material.unlit) {
        o.base = as_accumulator<channels_of<Tier>>(material.diffuse);
        return o;
    }
    o.base = as_accumulator<channels_of<Tier>>(material.emissive);
    if constexpr (N.ambient)
        for (const Light& light : lights)
            if (light.kind == LightKind::ambient)
                detail::add_product(o.base, detail::make_product<TierIn<highp, channels_of<Tier>>>(material.ambient_color(), light.diffuse, light.intensity));
    o.local_viewer = camera.sees_locally();
    o.reflects = material.reflection == Reflection::phong;
    if constexpr (N.local_viewer) o.eye = frame.point(as_block(camera.eye));
    if constexpr (N.specular) o.view = UnitVectorOf<Tier>::from(frame.direction(view_rotation.row[2]));
    return o;
}

namespace detail {
/// Where a lamp stands, and how it fades.
template <Needs N, PrecisionTier Tier>
constexpr void place_lamp(ObjectLight<Tier>& o, const LightingFrame& frame, const Camera& camera, const Mat3& view_to_world, const Light& light) {
    if (light.space == Space::object) o.point = frame.object_point(light.position);
    else if (light.space == Space::world) o.point = frame.point(as_block(light.position));
    else o.point = frame.point(view_to_world * as_block(light.position) + as_block(camera.eye));
    if constexpr (N.attenuation) o.attenuation = frame.attenuation(light.attenuation, o.point.bits);
}
}  // namespace detail

/// One light as one object sees it. A lamp in a pipeline without lamps, or another light in one without any, is none.
template <PrecisionTier Tier, Needs N = all_needs>
constexpr ObjectLight<Tier> make_object_light(const Camera& camera, const Mat3& view_rotation, const Light& light,
                                              const Material& material, const Pose& pose, const Mesh& mesh) {
    const detail::LightingFrame frame(pose, mesh);
    ObjectLight<Tier> o;
    o.is_point = light.is_lamp();
    if (o.is_point ? !N.point : !N.directional) return o;
    if constexpr (N.diffuse) o.diffuse = detail::make_product<Tier>(material.diffuse, light.diffuse, light.intensity);
    if constexpr (N.specular) o.specular = detail::make_product<Tier>(material.specular, light.specular, light.intensity);
    const Mat3 to_world = transpose(view_rotation);
    if constexpr (N.point)
        if (o.is_point) {
            detail::place_lamp<N>(o, frame, camera, to_world, light);
            return o;
        }
    if constexpr (N.directional) {
        const Normal30 direction = detail::direction_in(frame, to_world, light.space, light.position);
        o.direction = UnitVectorOf<Tier>::from(direction);
        if constexpr (N.halfway) o.half = UnitVectorOf<Tier>::from(half_vector(direction, frame.direction(view_rotation.row[2])));
    }
    return o;
}

}  // namespace shade16
