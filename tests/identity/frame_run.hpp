// Draws a scene in bands, and says a hash of the frame.
#pragma once

#include <runtime/console.hpp>
#include <runtime/fnv1a.hpp>

#include "shade16/shade16.hpp"

namespace shade16::identity {

/// The pixels' bytes, in the order in which a display would take them.
template <PixelFormat Format>
struct FrameHash {
    Fnv1a hash{};

    void flush(Area, const typename Format::Pixel* pixels, size_t bytes, bool) {
        const auto* const byte = reinterpret_cast<const unsigned char*>(pixels);
        for (size_t i = 0; i < bytes; ++i) hash.add(byte[i]);
    }
    void wait() {}
};

/// The memory is on the stack, so that several frames need no more of it than the largest.
template <const Scene& scene, PrecisionTier Tier, PixelFormat Format>
[[gnu::noinline]] void say_frame(const char* name) {
    constexpr Viewport viewport{48, 32};
    constexpr Channels channels = channels_of_format<Format>;
    constexpr Needs needs = needs_of(scene);
    Workspace<scene, Tier, VertexStore::replay, usual_slots, channels> workspace;
    BandBuffer<Format, viewport.width, 8, needs.depth> bands[1];
    Renderer<scene, Tier, VertexStore::replay, needs, channels> renderer(workspace);
    FrameHash<Format> display;
    present(renderer, {}, viewport, bands, display);

    console::print(name);
    console::print(" ");
    console::print_hex(display.hash.value);
    console::print("\n");
}

}  // namespace shade16::identity
