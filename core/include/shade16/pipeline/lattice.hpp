// The frame that light is computed in: the object's own, before rotation and after scale, in units of its lattice. That is
// a rigid change of frame, so stored normals need no transform, a position is an exact integer, and a light may be as far
// away as it likes.
#pragma once

#include "shade16/num/block.hpp"
#include "shade16/num/normalize.hpp"
#include "shade16/num/rsqrt.hpp"
#include "shade16/scene/scene.hpp"

namespace shade16 {

/// A point with fraction bits of its own: in units of 2^-bits of the object's lattice, below 2^28.
struct LatticePoint {
    IVec3 position{};
    int8_t bits = 0;  // at most 12; negative for a point very far away
};

/// A scale that differs by axis, as factors at most 1: what the lattice is multiplied by, and what its normals are.
struct Stretch {
    Q30 position[3]{}, normal[3]{};
    bool differs = false;  // by axis
};

inline constexpr uint32_t attenuation_max_error = scaled_sqrt_max_error + reciprocal_max_error + 6;  // relative, of 2^-32: two sums, a product

/// A point light's attenuation in powers of a distance in units of its LatticePoint.
struct LatticeAttenuation {
    bool fades = false;
    Scaled constant{}, linear{}, quadratic{};

    /// 1 / (constant + linear d + quadratic d^2) at the squared distance d^2. Error: attenuation_max_error.
    SHADE16_ONCE constexpr Scaled at(Scaled squared_distance) const {
        return reciprocal(constant + linear * sqrt(squared_distance) + quadratic * squared_distance);
    }
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
    const int32_t unit = max<int32_t>(v.top() - 28, -12);
    return {v.in_units_of(unit), static_cast<int8_t>(clamp<int32_t>(-unit, -100, 12))};
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
        return {a.fades(), scaled(a.constant), scaled(a.linear) * unit, scaled(a.quadratic) * unit * unit};
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

}  // namespace shade16
