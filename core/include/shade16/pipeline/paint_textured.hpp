// Textures under flat and Gouraud shading, and on unlit surfaces: light interpolated in two sums, and multiplied pixel by pixel.
#pragma once

#include "shade16/pipeline/paint_samples.hpp"
#include "shade16/pipeline/surface.hpp"

namespace shade16 {

/// Light and place in the texture, interpolated linearly over the screen. Sums of the accumulator up to 16.
struct LitSample {
    IVec3 body{}, shine{};
    TextureSample at{};
};

template <Needs N>
struct LitKind {
    using Sample = LitSample;
    static constexpr bool by_depth = detail::looks_up(N) && N.perspective_texture;
    template <class F, class... S>
    SHADE16_INLINE static constexpr void for_each_number(F f, S&... s) {
        f(s.body.x...), f(s.body.y...), f(s.body.z...);
        if constexpr (N.specular) f(s.shine.x...), f(s.shine.y...), f(s.shine.z...);
        detail::for_each_coordinate<N>(f, s...);
    }
};

constexpr LitSample lit_sample(const SplitLight& light, const TextureSample& at) {
    const auto limited = [](uint32_t c) { return static_cast<int32_t>(min(c, (uint32_t{1} << 28) - 1)); };
    return {{limited(light.body.r), limited(light.body.g), limited(light.body.b)}, {limited(light.shine.r), limited(light.shine.g), limited(light.shine.b)}, at};
}

template <Needs N>
struct TexturedLight {
    using Kind = LitKind<N>;

    TextureLookup maps{};

    /// body * texture + shine, saturated and rounded once.
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr typename Format::Pixel pixel(const LitSample& s) const {
        Accumulator sum = inside(s.body);
        detail::modulate(sum, maps.template color<N>(maps.template place<N>(s.at)));
        if constexpr (N.specular) detail::accumulate(sum, inside(s.shine));
        return detail::pixel_of_light<Format>(sum);
    }

private:
    /// A step may lead a unit below zero.
    SHADE16_INLINE static constexpr Accumulator inside(const IVec3& c) {
        const auto channel = [](int32_t v) { return static_cast<uint32_t>(max(v, int32_t{0})); };
        return {channel(c.x), channel(c.y), channel(c.z)};
    }
};

}  // namespace shade16
