// Material: how a surface answers light, in Blinn-Phong and MTL words.
#pragma once

#include "shade16/num/q16.hpp"
#include "shade16/num/unorm.hpp"
#include "shade16/scene/texture.hpp"

namespace shade16 {

/// Where light is computed. flat: one colour a face, lit at its centre with its face normal. gouraud: at the vertices, and
/// colours are interpolated. phong: at every pixel, from interpolated and renormalised normals.
enum class Shading : uint8_t { flat, gouraud, phong };

/// How Phong shading interpolates normals. linear: by components. spherical: along great circles, first along the edges, then
/// along each row of pixels; opposite normals turn by way of the axis that is farthest from them, x before y before z.
enum class NormalPath : uint8_t { linear, spherical };

/// What a highlight is computed from, both by the chord u and with 1 - u to the power of the shininess. blinn_phong: the half
/// vector, u = |N - H|^2 / 2. phong: the mirrored light, u = |R - V|^2 / 2 with R = 2(N.L)N - L; no highlight where R.V <= 0.
enum class Reflection : uint8_t { blinn_phong, phong };

/// Phong shading by a table over normals in place of light a pixel, 64 x 64 entries an object: for lights at infinity, an infinite
/// viewer and surfaces without maps and vertex colours; elsewhere it is not used. nearest: one entry. bilinear: four.
/// Its error is light_table_max_error, far above any tier's promise: it holds neither mediump's nor lowp's.
enum class LightTable : uint8_t { none, nearest, bilinear };

/// The ambient colour; the diffuse one unless it is given.
struct AmbientColor {
    Rgb color{};
    bool given = false;
    constexpr AmbientColor() = default;
    constexpr AmbientColor(Rgb c) : color(c), given(true) {}
    friend constexpr bool operator==(AmbientColor, AmbientColor) = default;
};

struct Material {
    AmbientColor ambient{};
    Rgb diffuse = rgb(0xCCCCCC);
    Rgb specular = black;
    Rgb emissive = black;
    Q16 shininess = 32;  // the exponent of the reflection, 1 to 1000, fractions welcome; clamped outside
    Reflection reflection = Reflection::blinn_phong;
    Shading shading = Shading::gouraud;
    NormalPath normal_path = NormalPath::linear;  // with Shading::phong
    LightTable light_table = LightTable::none;    // with Shading::phong
    MapPointer<Texture> texture{};     // a factor of ambient and diffuse light
    MapPointer<SlopeMap> bump{};       // turns the normals of Shading::phong
    Filter filter = Filter::nearest;   // of both
    Mapping mapping = Mapping::affine;
    Unorm16 alpha{Unorm16::one};  // kept for whoever asks; surfaces are drawn opaque
    bool unlit = false;  // shows its diffuse colour, or the vertex colours, whatever the light

    constexpr Rgb ambient_color() const { return ambient.given ? ambient.color : diffuse; }
    friend constexpr bool operator==(const Material&, const Material&) = default;
};

namespace detail {
constexpr bool is_flat(const Material& m) { return m.shading == Shading::flat && !m.unlit; }
constexpr bool is_phong(const Material& m) { return m.shading == Shading::phong && !m.unlit; }
}  // namespace detail

/// The Phong exponent whose highlight is as wide as a Blinn-Phong one, and the other way round: four to one, since R turns away
/// from V twice as fast as N from H. They clamp: below 4 there is no Phong highlight as wide, above 250 no Blinn-Phong one as
/// narrow.
/// Error   where light, normal and viewer lie in a plane, at most matching_max_error / (Blinn-Phong exponent) of full scale; elsewhere
///         Phong's highlights are rounder than Blinn-Phong's, which stretch at grazing light.
inline constexpr Q16 matching_max_error = Q16::from_raw(67174);  // 1.025; from an exponent of 32 on it is below 0.6
constexpr Q16 phong_shininess_matching(Q16 blinn_phong) {
    return Q16::from_raw(clamp<int32_t>(blinn_phong.raw, int32_t{4} * 65536, int32_t{1000} * 65536) >> 2);
}
constexpr Q16 blinn_phong_shininess_matching(Q16 phong) {
    return Q16::from_raw(clamp<int32_t>(phong.raw, int32_t{1} * 65536, int32_t{250} * 65536) * 4);
}

}  // namespace shade16
