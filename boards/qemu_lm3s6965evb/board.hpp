// Stellaris LM3S6965 evaluation board (Cortex-M3, 64 KB of RAM) with its OLED of 128x64 pixels in 16 greys.
// Source: Stellaris LM3S6965 Evaluation Board User's Manual, Texas Instruments: D/C# is PC7, the display's select PD0.
#pragma once

#include <assets/teapot.hpp>
#include <display/ssd0323.hpp>
#include <mcu/lm3s.hpp>
#include <runtime/seen_on.hpp>

namespace shade16 {

struct Board {
    static constexpr const char* name = "qemu_lm3s6965evb";
    static constexpr uint32_t cpu_hz = 50'000'000;
    static constexpr uint32_t flash_bytes = 256 * 1024;
    static constexpr uint32_t ram_bytes = 64 * 1024;

    using Panel = Ssd0323<lm3s::Ssi0<cpu_hz, 1'000'000>, lm3s::Output<'C', 7>, lm3s::Output<'D', 0>>;
    using Pixel = Panel::Pixel;
    static constexpr int width_px = Panel::width_px;
    static constexpr int height_px = Panel::height_px;
    static constexpr int band_rows = 16;
    static constexpr int bands = 2;

    static constexpr VertexStore vertex_store = VertexStore::keep;
    static constexpr Mesh model = assets::teapot;
    static constexpr Q16 model_scale = Q16::from_raw(65536 / 8);
    static constexpr Rgb background = rgb(0x101820);

    SeenOn<Panel> display;
};

}  // namespace shade16
