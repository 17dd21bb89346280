// The STM32VLDISCOVERY, an STM32F100RB, as QEMU emulates it: 8 KB of RAM and no display.
#pragma once

#include <runtime/hash_sink.hpp>
#include <shade16/shade16.hpp>

namespace shade16 {

struct Board {
    static constexpr const char* name = "qemu_stm32vldiscovery";
    static constexpr uint32_t cpu_hz = 24'000'000;
    static constexpr uint32_t flash_bytes = 128 * 1024;
    static constexpr uint32_t ram_bytes = 8 * 1024;

    using Pixel = Rgb565;
    static constexpr int width_px = 128;
    static constexpr int height_px = 64;
    static constexpr int band_rows = 8;
    static constexpr int bands = 1;

    static constexpr VertexStore vertex_store = VertexStore::replay;
    static constexpr Mesh model = torus<24, 12>.mesh();
    static constexpr Q16 model_scale = 1;
    static constexpr Rgb background = rgb(0x101820);

    HashSink display;
};

}  // namespace shade16
