// Texture: a picture in flash, and the relief of a surface.
#pragma once

#include "shade16/num/bits.hpp"
#include "shade16/scene/view.hpp"

namespace shade16 {

/// Where a vertex lies in a texture, in units of 2^-texcoord_bits of its mesh: 1.0 is the whole width or height. Beyond
/// 0 to 1 the texture repeats.
struct TexCoord16 {
    int16_t s = 0, t = 0;
    friend constexpr bool operator==(TexCoord16, TexCoord16) = default;
};

/// nearest: the texel that a point lies in. bilinear: four, weighed.
enum class Filter : uint8_t { nearest, bilinear };

/// How texture coordinates run over a triangle. affine: linearly on the screen. perspective: linearly in space, for a
/// reciprocal a pixel.
enum class Mapping : uint8_t { affine, perspective };

/// RGB565 texels, row by row from t = 0, width and height powers of two. A texel's channel stands for its bits repeated
/// to 16: code 31 of 5 bits is 1.0.
struct Texture {
    View<uint16_t> texels{};  // 2^(width_log2 + height_log2) of them
    uint8_t width_log2 = 0, height_log2 = 0;  // 0 to 11
};

/// A slope of the surface against its tangent plane: n.x / n.z and n.y / n.z of a tangent-space normal n.
struct Slope8 {
    int8_t s = 0, t = 0;
    friend constexpr bool operator==(Slope8, Slope8) = default;
};

/// A bump or normal map as slopes: two bytes a texel, and no root to restore a third component with.
struct SlopeMap {
    View<Slope8> texels{};
    uint8_t width_log2 = 0, height_log2 = 0;  // 0 to 11
    uint8_t fraction_bits = 7;  // of a slope, 4 to 11: slopes reach 127 * 2^-fraction_bits
};

/// Where a map lies, if there is one. It remembers whether it was given, because a compiler that reckons with objects at address 0
/// (for AVR, or under a sanitizer) takes the question whether `&map` is null for no constant.
template <class Map>
struct MapPointer {
    const Map* at = nullptr;
    bool is_given = false;

    constexpr MapPointer() = default;
    constexpr MapPointer(decltype(nullptr)) {}
    constexpr MapPointer(const Map* map) : at(map), is_given((__builtin_is_constant_evaluated() && !__builtin_constant_p(map != nullptr)) || map != nullptr) {}

    constexpr const Map& operator*() const { return *at; }
    constexpr const Map* operator->() const { return at; }
    friend constexpr bool operator==(const MapPointer& a, decltype(nullptr)) { return !a.is_given; }
    friend constexpr bool operator==(const MapPointer&, const MapPointer&) = default;
};

}  // namespace shade16
