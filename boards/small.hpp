// A board with 16 KB of RAM: what runs here runs anywhere.
#pragma once

#include <runtime/hash_sink.hpp>
#include <shade16/shade16.hpp>

namespace shade16 {

struct Small {
    static constexpr uint32_t ram_bytes = 16 * 1024;

    using Pixel = Rgb565;
    static constexpr int width_px = 128;
    static constexpr int height_px = 64;
    static constexpr int band_rows = 8;
    static constexpr int bands = 1;

    // A vertex cache of 64 slots instead of 288 vertices: most of the RAM stays with the application.
    static constexpr VertexStore vertex_store = VertexStore::replay;
    static constexpr Mesh model = torus<24, 12>.mesh();
    static constexpr Q16 model_scale = 1;
    static constexpr Rgb background = rgb(0x101820);

    HashSink display;
};

}  // namespace shade16
