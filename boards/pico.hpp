// Raspberry Pi Pico (RP2040, Cortex-M0+, 264 KB of RAM) with a display on SPI 0.
// Source: Raspberry Pi Pico Datasheet, Raspberry Pi Ltd.
#pragma once

#include <assets/teapot.hpp>
#include <mcu/rp2040/spi_display.hpp>
#include <runtime/seen_on.hpp>

namespace shade16 {

struct Pico {
    static constexpr uint32_t cpu_hz = 125'000'000;
    static constexpr uint32_t flash_bytes = 2 * 1024 * 1024 - 256;  // behind the boot stage
    static constexpr uint32_t ram_bytes = 264 * 1024;

    using Pixel = Rgb565Swapped;
    static constexpr int band_rows = 40;
    static constexpr int bands = 2;  // one is drawn while the other is sent

    static constexpr VertexStore vertex_store = VertexStore::keep;
    static constexpr Mesh model = assets::teapot;
    static constexpr Q16 model_scale = Q16::from_raw(65536 / 12);
    static constexpr Rgb background = rgb(0x101820);
};

}  // namespace shade16
