// Stellaris LM3S811 evaluation board (Cortex-M3, 8 KB of RAM) with its monochrome OLED of 96x16 pixels.
// Source: Stellaris LM3S811 Evaluation Board User's Manual, Texas Instruments.
#pragma once

#include <assets/teapot.hpp>
#include <display/ssd0303.hpp>
#include <mcu/lm3s.hpp>
#include <runtime/seen_on.hpp>

namespace shade16 {

struct Board {
    static constexpr const char* name = "qemu_lm3s811evb";
    static constexpr uint32_t cpu_hz = 50'000'000;
    static constexpr uint32_t flash_bytes = 64 * 1024;
    static constexpr uint32_t ram_bytes = 8 * 1024;

    using Panel = Ssd0303<lm3s::I2c<cpu_hz>>;
    using Pixel = Dithered<Panel::Pixel, bayer4>;
    static constexpr int width_px = Panel::width_px;
    static constexpr int height_px = Panel::height_px;
    static constexpr int band_rows = 8;
    static constexpr int bands = 1;

    static constexpr VertexStore vertex_store = VertexStore::replay;
    static constexpr Mesh model = assets::teapot;
    static constexpr Q16 model_scale = Q16::from_raw(65536 / 7);
    static constexpr Rgb background = black;

    SeenOn<Panel, Pixel> display;
};

}  // namespace shade16
