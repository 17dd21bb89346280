// Stage 3a: the lights as one object sees them, made once a frame. Lighting runs in the object's frame before rotation
// and after its scale, in units of its lattice: a rigid change of frame, so stored normals need no transform, a position
// is an exact integer, and a light may be as far away as it likes.
#pragma once

#include "shade16/num/accumulator.hpp"
#include "shade16/num/block.hpp"
#include "shade16/num/normalize.hpp"
#include "shade16/num/shininess.hpp"
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

/// A point with fraction bits of its own: in units of 2^-bits of the object's lattice, below 2^28.
struct LatticePoint {
    IVec3 position{};
    int8_t bits = 0;  // at most 12; negative for a point very far away
};

/// Light colour times material colour times intensity: three mantissas and one exponent, m * 2^(exponent - 16) in the
/// 16-bit tiers and m * 2^(exponent - 32) in highp.
struct LightProduct {
    uint32_t r = 0, g = 0, b = 0;
    int16_t exponent = 0;

    constexpr bool is_zero() const { return (r | g | b) == 0; }
};

/// A point light's attenuation in powers of a distance in units of its LatticePoint.
struct LatticeAttenuation {
    bool fades = false;
    Scaled constant{}, linear{}, quadratic{};

    /// 1 / (constant + linear d + quadratic d^2) at the squared distance d^2. Error: relative 2^-22.
    SHADE16_ONCE constexpr Scaled at(Scaled squared_distance) const {
        return reciprocal(constant + linear * sqrt(squared_distance) + quadratic * squared_distance);
    }
};

template <PrecisionTier Tier>
struct ObjectLight {
    bool is_point = false;
    LatticeAttenuation attenuation{};
    LatticePoint point{};          // of a point light
    UnitVector<Tier> direction{};  // of a directional one, towards the light
    UnitVector<Tier> half{};       // and, with an infinite viewer, the half vector
    LightProduct diffuse{}, specular{};
};

/// A scale that differs by axis, as factors at most 1: what the lattice is multiplied by, and what its normals are.
struct Stretch {
    Q30 position[3]{}, normal[3]{};
    bool differs = false;  // by axis
};

/// What lights one object for one frame.
template <PrecisionTier Tier>
struct ObjectLighting {
    Accumulator base{};  // ambient, emissive; or the colour of an unlit object
    bool local_viewer = false;
    LatticePoint eye{};
    UnitVector<Tier> view{};  // of an infinite viewer
    Stretch stretch{};
};

namespace detail {
constexpr Scaled scaled_scale(Q16 s) { return Scaled::normalized(magnitude(max(s.raw, int32_t{1})), -16); }

/// a / b for 0 < a <= b, as Q30.
SHADE16_ONCE constexpr Q30 ratio(Q16 a, Q16 b) {
    if (a == b) return {Q30::one};
    return Q30::from_raw(static_cast<int64_t>((scaled_scale(a) * reciprocal(scaled_scale(b))).to_fixed(30)));
}

constexpr Stretch make_stretch(Vec3 scale) {
    const Q16 s[3] = {scale.x, scale.y, scale.z};
    const Q16 largest = max(s[0], max(s[1], s[2])), smallest = min(s[0], min(s[1], s[2]));
    Stretch stretch;
    stretch.differs = largest != smallest;
    for (int i = 0; i < 3; ++i) {
        stretch.position[i] = ratio(s[i], largest);
        stretch.normal[i] = ratio(smallest, s[i]);
    }
    return stretch;
}

constexpr LatticePoint as_lattice_point(const BlockVector& v) {
    const int unit = max(v.top() - 28, -12);
    return {v.in_units_of(unit), static_cast<int8_t>(clamp(-unit, -100, 12))};
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

constexpr void add_product(Accumulator& sum, const LightProduct& p) {
    accumulate(sum.r, scaled_term(p.r, 8 - p.exponent));
    accumulate(sum.g, scaled_term(p.g, 8 - p.exponent));
    accumulate(sum.b, scaled_term(p.b, 8 - p.exponent));
}

/// Where the frame of reference of lighting lies for one object.
struct LightingFrame {
    const Pose& pose;
    const Mesh& mesh;
    Scaled inverse_scale;  // lattice steps a world unit along the largest scale
    Mat3 to_object;

    constexpr LightingFrame(const Pose& p, const Mesh& m)
        : pose(p), mesh(m), inverse_scale(lattice_steps(p.scale, m.fraction_bits)), to_object(transpose(p.rotation)) {}

    /// The attenuation, for distances in 2^-bits of the lattice.
    constexpr LatticeAttenuation attenuation(const Attenuation& a, int bits) const {
        const auto scaled = [](Q16 v) { return Scaled::normalized(magnitude(max(v.raw, int32_t{0})), -16); };
        Scaled unit = reciprocal(inverse_scale);  // world units a lattice step
        unit.exponent = static_cast<int16_t>(unit.exponent - bits);
        return {a != Attenuation{}, scaled(a.constant), scaled(a.linear) * unit, scaled(a.quadratic) * unit * unit};
    }
    /// A direction in the world.
    constexpr Normal30 direction(const Normal30& world) const { return to_object_direction(world); }
    /// A point in the world.
    constexpr LatticePoint point(const BlockVector& world) const {
        return from_scaled(to_object * (world - as_block(pose.translation)));
    }
    /// A point in the object's own coordinates.
    constexpr LatticePoint object_point(Vec3 p) const { return from_scaled(component_product(pose.scale, p)); }

private:
    static constexpr Scaled lattice_steps(Vec3 s, int bits) {
        Scaled steps = reciprocal(scaled_scale(max(s.x, max(s.y, s.z))));
        steps.exponent = static_cast<int16_t>(steps.exponent + bits);
        return steps;
    }
    constexpr Normal30 to_object_direction(const Normal30& world) const { return normalize_finely(rotate(to_object, raw(world))); }
    SHADE16_ONCE constexpr LatticePoint from_scaled(const BlockVector& v) const {
        return as_lattice_point((v - component_product(pose.scale, mesh.centre)) * inverse_scale);
    }
};
}  // namespace detail

/// The half vector of two unit vectors, formed in 32 bits; zero where they are opposite.
SHADE16_ONCE constexpr Normal30 half_vector(const Normal30& a, const Normal30& b) {
    return normalize30({(a.x.raw >> 1) + (b.x.raw >> 1), (a.y.raw >> 1) + (b.y.raw >> 1), (a.z.raw >> 1) + (b.z.raw >> 1)});
}

/// What one object keeps of the scene's ambient light, viewer and scale.
template <PrecisionTier Tier>
constexpr ObjectLighting<Tier> make_object_lighting(const Camera& camera, const Mat3& view_rotation, View<Light> lights,
                                                    const Material& material, const Pose& pose, const Mesh& mesh) {
    const detail::LightingFrame frame(pose, mesh);
    ObjectLighting<Tier> o;
    o.stretch = detail::make_stretch(pose.scale);
    if (material.unlit) {
        o.base = as_accumulator(material.diffuse);
        return o;
    }
    o.base = as_accumulator(material.emissive);
    for (const Light& light : lights)
        if (light.kind == LightKind::ambient)
            detail::add_product(o.base, detail::make_product<highp>(material.ambient_color(), light.diffuse, light.intensity));
    o.local_viewer = camera.sees_locally();
    o.eye = frame.point(as_block(camera.eye));
    o.view = UnitVectorOf<Tier>::from(frame.direction(view_rotation.row[2]));
    return o;
}

/// One light as one object sees it.
template <PrecisionTier Tier>
constexpr ObjectLight<Tier> make_object_light(const Camera& camera, const Mat3& view_rotation, const Light& light,
                                              const Material& material, const Pose& pose, const Mesh& mesh) {
    const detail::LightingFrame frame(pose, mesh);
    ObjectLight<Tier> o;
    o.is_point = light.kind == LightKind::point;
    o.diffuse = detail::make_product<Tier>(material.diffuse, light.diffuse, light.intensity);
    o.specular = detail::make_product<Tier>(material.specular, light.specular, light.intensity);
    const Mat3 to_world = transpose(view_rotation);
    if (o.is_point) {
        if (light.space == Space::object) o.point = frame.object_point(light.position);
        else if (light.space == Space::world) o.point = frame.point(as_block(light.position));
        else o.point = frame.point(to_world * as_block(light.position) + as_block(camera.eye));
        o.attenuation = frame.attenuation(light.attenuation, o.point.bits);
        return o;
    }
    Normal30 direction = normalize(light.position);
    if (light.space == Space::view) direction = normalize_finely(rotate(to_world, raw(direction)));
    if (light.space != Space::object) direction = frame.direction(direction);
    o.direction = UnitVectorOf<Tier>::from(direction);
    o.half = UnitVectorOf<Tier>::from(half_vector(direction, frame.direction(view_rotation.row[2])));
    return o;
}

}  // namespace shade16
