// Phong shading: every pixel is lit by itself.
#pragma once

#include "shade16/pipeline/paint_samples.hpp"
#include "shade16/pipeline/surface.hpp"
#include "shade16/pipeline/tangents.hpp"

namespace shade16 {

/// What lights the pixels of one face.
template <Needs N, PrecisionTier Tier>
struct PixelLight {
    static constexpr Channels channels = channels_of<Tier>;
    using Kind = SurfaceKind<N, channels>;

    const ObjectLighting<Tier>& lighting;
    View<ObjectLight<Tier>> lights;
    const Shininess<Tier>* shininess;
    bool has_colors;
    TextureLookup maps{};
    FaceTangents tangents{};

    /// Error   as light_point, with the normal's renormalisation once more.
    /// Cost    that of a vertex, and a square root; with a relief two.
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr typename Format::Pixel pixel(const SurfaceSample& s) const {
        return detail::pixel_of_light<Format>(lit(s));
    }
    /// The same before it is rounded.
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr ByChannel<channels, uint32_t> codes(const SurfaceSample& s) const {
        return detail::codes_of_light<Format>(lit(s));
    }

private:
    SHADE16_INLINE constexpr AccumulatorOf<channels> lit(const SurfaceSample& s) const {
        SurfacePoint point{};
        if constexpr (detail::carries_position(N)) {
            if constexpr (Arithmetic<Tier>::wide) point = {s.position, 8192};
            else point = {{s.position.x >> 11, s.position.y >> 11, s.position.z >> 11}, 4};
        }
        TextureSample at{};
        if constexpr (detail::looks_up(N)) at = maps.template place<N>(s.at);
        UnitVector<Tier> normal = UnitVectorOf<Tier>::normalize(s.normal);
        if constexpr (N.bump)
            if (maps.bump != nullptr) {
                const auto slope = maps.template slope<N>(at);
                normal = turned<Tier>(normal, tangents, slope.s, slope.t, maps.slope_bits);
            }
        FactorIn<channels> factor{};
        const bool has_factor = set_factor(factor, s, at);
        return light_point<N>(lighting, lights, shininess, point, normal, has_factor ? &factor : nullptr);
    }
    SHADE16_INLINE constexpr bool set_factor([[maybe_unused]] FactorIn<channels>& factor, [[maybe_unused]] const SurfaceSample& s,
                                             [[maybe_unused]] const TextureSample& at) const {
        const bool colored = N.vertex_colors && has_colors, textured = N.texture && maps.texture != nullptr;
        if constexpr (N.vertex_colors)
            if (colored) {
                if constexpr (channels == Channels::luma) factor.luma = q32(s.color.x);
                else factor = ColorFactor{q32(s.color.x), q32(s.color.y), q32(s.color.z)};
            }
        if constexpr (N.texture)
            if (textured) {
                const FactorIn<channels> texel = as_factor<channels>(maps.template color<N>(at));
                factor = colored ? detail::product(factor, texel) : texel;
            }
        return colored || textured;
    }
    static constexpr uint32_t q32(int32_t q29) { return static_cast<uint32_t>(clamp<int32_t>(q29, 0, (int32_t{1} << 29) - 1)) << 3; }
};

}  // namespace shade16
