// Raspberry Pi Pico (RP2040, Cortex-M0+, 264 KB of RAM) with a display on SPI 0.
// Source: Raspberry Pi Pico Datasheet, Raspberry Pi Ltd.
#pragma once

#include <assets/teapot.hpp>
#include <display/four_wire.hpp>
#include <mcu/rp2040/spi.hpp>
#include <mcu/rp2040/uart.hpp>
#include <runtime/seen_on.hpp>

namespace shade16 {

struct Pico {
    static constexpr uint32_t cpu_hz = 125'000'000;
    static constexpr uint32_t flash_bytes = 2 * 1024 * 1024 - 256;  // behind the boot stage
    static constexpr uint32_t ram_bytes = 264 * 1024;

    using Uart = rp2040::Uart0<>;
    /// Clock 18, data 19, select 17, data/command 20, reset 21, backlight 22.
    template <uint32_t Hz>
    using Bus = FourWire<rp2040::Spi0<18, 19, Hz>, rp2040::Output<17>, rp2040::Output<20>, rp2040::Output<21>, rp2040::Output<22>>;

    using Pixel = Rgb565Swapped;
    static constexpr int band_rows = 40;
    static constexpr int bands = 2;  // one is drawn while the other is sent

    static constexpr VertexStore vertex_store = VertexStore::keep;
    static constexpr Mesh model = assets::teapot;
    static constexpr Q16 model_scale = Q16::from_raw(65536 / 12);
    static constexpr Rgb background = rgb(0x101820);
};

}  // namespace shade16
