// STM32F405 or STM32F407 (Cortex-M4, 128 KB of RAM that DMA reaches) and a panel of 320x240 (ILI9341), lying on its side. Clock A5, data A7,
// select A4, data/command A3, reset A1, backlight A0; what it says goes to A2.
#pragma once

#include <assets/teapot.hpp>
#include <display/four_wire.hpp>
#include <display/ili9341.hpp>
#include <mcu/stm32f4/spi.hpp>
#include <mcu/stm32f4/usart.hpp>
#include <runtime/seen_on.hpp>

namespace shade16 {

struct Board {
    static constexpr const char* name = "stm32f4_ili9341";
    static constexpr uint32_t cpu_hz = stm32f4::cpu_hz;
    static constexpr uint32_t flash_bytes = 1024 * 1024;
    static constexpr uint32_t ram_bytes = 128 * 1024;

    using Uart = stm32f4::Usart2<>;
    template <class Port = Registers>
    using Bus = FourWire<stm32f4::Spi1<stm32f4::Pin{'A', 5}, stm32f4::Pin{'A', 7}, 21'000'000, Port>, stm32f4::Output<stm32f4::Pin{'A', 4}, Port>,
                         stm32f4::Output<stm32f4::Pin{'A', 3}, Port>, stm32f4::Output<stm32f4::Pin{'A', 1}, Port>, stm32f4::Output<stm32f4::Pin{'A', 0}, Port>>;
    using Panel = DcsDisplay<Bus<>, ili9341, Orientation{1}>;
    using Pixel = Panel::Pixel;
    static constexpr int width_px = Panel::width_px;
    static constexpr int height_px = Panel::height_px;
    static constexpr int band_rows = 40;
    static constexpr int bands = 2;  // one is drawn while the other is sent

    static constexpr VertexStore vertex_store = VertexStore::keep;
    static constexpr Mesh model = assets::teapot;
    static constexpr Q16 model_scale = Q16::from_raw(65536 / 12);
    static constexpr Rgb background = rgb(0x101820);

    SeenOn<Panel> display;
};

}  // namespace shade16
