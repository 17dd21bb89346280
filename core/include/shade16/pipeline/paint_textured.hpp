// Textures under flat and Gouraud shading, and on unlit surfaces: light interpolated in two sums, and multiplied pixel by pixel.
#pragma once

#include "shade16/pipeline/paint_samples.hpp"
#include "shade16/pipeline/surface.hpp"

namespace shade16 {

/// How far an interpolated sum may be from the exact one, for each pixel of the frame's longer side: two slopes, each rounded down.
inline constexpr uint32_t lit_sample_max_error_a_pixel = 2;  // of 2^-24

/// Light and place in the texture, interpolated linearly over the screen. Sums of the accumulator up to 16; x alone in a grey
/// pipeline.
struct LitSample {
    IVec3 body{}, shine{};
    TextureSample at{};
};

template <Needs N, Channels C = Channels::rgb>
struct LitKind {
    using Sample = LitSample;
    static constexpr bool by_depth = detail::looks_up(N) && N.perspective_texture;
    template <class F, class... S>
    SHADE16_INLINE static constexpr void for_each_number(F f, S&... s) {
        f(s.body.x...);
        if constexpr (C == Channels::rgb) f(s.body.y...), f(s.body.z...);
        if constexpr (N.specular) f(s.shine.x...);
        if constexpr (N.specular && C == Channels::rgb) f(s.shine.y...), f(s.shine.z...);
        detail::for_each_coordinate<N>(f, s...);
    }
};

template <Channels C>
constexpr LitSample lit_sample(const SplitLightOf<C>& light, const TextureSample& at) {
    const auto limited = [](uint32_t c) { return static_cast<int32_t>(min(c, (uint32_t{1} << 28) - 1)); };
    if constexpr (C == Channels::luma) return {{limited(light.body.luma), 0, 0}, {limited(light.shine.luma), 0, 0}, at};
    else return {{limited(light.body.r), limited(light.body.g), limited(light.body.b)}, {limited(light.shine.r), limited(light.shine.g), limited(light.shine.b)}, at};
}

template <Needs N, Channels C = Channels::rgb>
struct TexturedLight {
    using Kind = LitKind<N, C>;

    TextureLookup maps{};

    /// body * texture + shine, saturated and rounded once.
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr typename Format::Pixel pixel(const LitSample& s) const {
        return detail::pixel_of_light<Format>(lit(s));
    }
    /// The same before it is rounded.
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr ByChannel<C, uint32_t> codes(const LitSample& s) const {
        return detail::codes_of_light<Format>(lit(s));
    }

private:
    SHADE16_INLINE constexpr AccumulatorOf<C> lit(const LitSample& s) const {
        AccumulatorOf<C> sum = inside(s.body);
        detail::modulate(sum, as_factor<C>(maps.template color<N>(maps.template place<N>(s.at))));
        if constexpr (N.specular) detail::accumulate(sum, inside(s.shine));
        return sum;
    }
    /// A step may lead a unit below zero.
    SHADE16_INLINE static constexpr AccumulatorOf<C> inside(const IVec3& c) {
        const auto channel = [](int32_t v) { return static_cast<uint32_t>(max(v, int32_t{0})); };
        if constexpr (C == Channels::luma) return {channel(c.x)};
        else return {channel(c.x), channel(c.y), channel(c.z)};
    }
};

}  // namespace shade16
