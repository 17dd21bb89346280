// SiFive HiFive1 (FE310, RV32IMAC, 16 KB of RAM) and a panel of 128x160 (ST7735). Clock 13, data 11, select 10, data/command 9, reset 8 and
// backlight 6, as the board's header counts; what it says goes to the USB port.
#pragma once

#include <display/four_wire.hpp>
#include <display/st7735.hpp>
#include <mcu/fe310/spi.hpp>
#include <mcu/fe310/uart.hpp>
#include <runtime/seen_on.hpp>

namespace shade16 {

struct Board {
    static constexpr const char* name = "hifive1_st7735";
    static constexpr uint32_t cpu_hz = fe310::cpu_hz;
    static constexpr uint32_t flash_bytes = 12 * 1024 * 1024;
    static constexpr uint32_t ram_bytes = 16 * 1024;

    using Uart = fe310::Uart0<>;
    template <class Port = Registers>
    using Bus = FourWire<fe310::Spi1<15'000'000, Port>, fe310::Output<2, Port>, fe310::Output<1, Port>, fe310::Output<0, Port>, fe310::Output<22, Port>>;
    using Panel = DcsDisplay<Bus<>, st7735_black_tab>;
    using Pixel = Panel::Pixel;
    static constexpr int width_px = Panel::width_px;
    static constexpr int height_px = Panel::height_px;
    static constexpr int band_rows = 16;
    static constexpr int bands = 1;

    // A vertex cache of 64 slots instead of 288 vertices: most of the RAM stays with the application.
    static constexpr VertexStore vertex_store = VertexStore::replay;
    static constexpr Mesh model = torus<24, 12>.mesh();
    static constexpr Q16 model_scale = 1;
    static constexpr Rgb background = rgb(0x101820);

    SeenOn<Panel> display;
};

}  // namespace shade16
