// Arm's MPS2 as QEMU emulates it: a board for trying things out, with memory to spare. The boards that include this
// differ in their processor alone, so that their frames must be the same.
#pragma once

#include <assets/teapot.hpp>
#include <runtime/hash_sink.hpp>
#include <shade16/shade16.hpp>

namespace shade16 {

struct Mps2 {
    static constexpr uint32_t cpu_hz = 25'000'000;
    static constexpr uint32_t flash_bytes = 4 * 1024 * 1024;
    static constexpr uint32_t ram_bytes = 4 * 1024 * 1024;

    using Pixel = Rgb565;
    static constexpr int width_px = 320;
    static constexpr int height_px = 240;
    static constexpr int band_rows = 40;
    static constexpr int bands = 2;

    static constexpr VertexStore vertex_store = VertexStore::keep;
    static constexpr Mesh model = assets::teapot;
    static constexpr Q16 model_scale = Q16::from_raw(65536 / 12);
    static constexpr Rgb background = rgb(0x101820);

    HashSink display;
};

}  // namespace shade16
