// Whole scenes drawn in constant expressions: what does not compile there is undefined, so a frame that does has no overflow,
// no bad shift and no write outside of its memory, whatever the numbers in the scene.
#pragma once

#include <gtest/gtest.h>

#include "shade16/shade16.hpp"

// Under sanitizers GCC takes no comparison of an address with null for a constant: there the same frames are drawn at run time, watched.
#if defined(__SANITIZE_ADDRESS__)
#define EXPECT_AT_COMPILE_TIME(...) EXPECT_TRUE((__VA_ARGS__))
#else
#define EXPECT_AT_COMPILE_TIME(...) static_assert(__VA_ARGS__)
#endif

namespace shade16::test {

/// A frame of the smallest pipeline for a scene.
template <const Scene& scene, PrecisionTier Tier = mediump, int32_t Width = 8, int32_t Height = 6, PixelFormat Format = Rgb888,
          VertexStore Store = VertexStore::keep>
constexpr auto frame_of() {
    constexpr Channels channels = channels_of_format<Format>;
    Workspace<scene, Tier, Store, usual_slots, channels> memory;
    Renderer<scene, Tier, Store, needs_of(scene), channels> renderer(memory);
    Framebuffer<Format, Width, Height> target;
    renderer.begin({}, {Width, Height});
    renderer.draw(target.band());
    return target;
}

/// Whether each pixel is that of a colour.
template <class Frame>
constexpr bool shows_only(const Frame& frame, Rgb color) {
    const auto wanted = nearest_pixel<typename Frame::Format>(color);
    for (const auto& pixel : frame.pixels)
        if (!(pixel == wanted)) return false;
    return true;
}
template <class Frame>
constexpr bool same_pixels(const Frame& a, const Frame& b) {
    for (size_t i = 0; i < Frame::count; ++i)
        if (!(a.pixels[i] == b.pixels[i])) return false;
    return true;
}

/// What must hold in every tier; `Check` is a generic lambda that takes one.
template <class Check>
constexpr bool in_every_tier(Check check) {
    return check(lowp{}) && check(mediump{}) && check(highp{});
}

}  // namespace shade16::test
