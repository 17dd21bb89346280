// What flat shading lights: a face's centre, its own normal and the mean of its vertex colours.
#pragma once

#include "shade16/pipeline/light.hpp"

namespace shade16 {

constexpr SurfacePoint face_centre(Position16 a, Position16 b, Position16 c) {
    return {{int32_t{a.x} + b.x + c.x, int32_t{a.y} + b.y + c.y, int32_t{a.z} + b.z + c.z}, 3};
}

/// The direction of (b - a) x (c - a), exact before one block-floating shift to 31 bits.
constexpr IVec3 face_normal(Position16 a, Position16 b, Position16 c) {
    const IVec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const int64_t x = multiply(u.y, v.z) - multiply(u.z, v.y);
    const int64_t y = multiply(u.z, v.x) - multiply(u.x, v.z);
    const int64_t z = multiply(u.x, v.y) - multiply(u.y, v.x);
    const int excess = max(0, 34 - leading_zeros(magnitude(x) | magnitude(y) | magnitude(z)));
    const auto shortened = [excess](int64_t c64) { return static_cast<int32_t>(shift_right_round(c64, excess)); };
    return {shortened(x), shortened(y), shortened(z)};
}

/// The mean of three vertex colours as a factor. Error: 3 * 2^-32.
constexpr ColorFactor mean_factor(const Rgb& a, const Rgb& b, const Rgb& c) {
    const auto mean = [](Unorm16 x, Unorm16 y, Unorm16 z) {
        constexpr uint32_t widened_third = 1'431'677'610;  // 65537 / 3, Q16
        return static_cast<uint32_t>(multiply(uint32_t{x.raw} + y.raw + z.raw, widened_third) >> 16);
    };
    return {mean(a.r, b.r, c.r), mean(a.g, b.g, c.g), mean(a.b, b.b, c.b)};
}

/// A face's normal as the tier lights it.
template <Needs N, PrecisionTier Tier>
constexpr UnitVector<Tier> lighting_face_normal(const ObjectLighting<Tier>& object, Position16 a, Position16 b, Position16 c) {
    IVec3 n = face_normal(a, b, c);
    if constexpr (N.stretch)
        if (object.stretch.differs) {
            const auto component = [&](int32_t k, int i) { return static_cast<int32_t>(multiply(k, object.stretch.normal[i].raw) >> 30); };
            n = {component(n.x, 0), component(n.y, 1), component(n.z, 2)};
        }
    return UnitVectorOf<Tier>::normalize(n);
}

}  // namespace shade16
