// Raspberry Pi Pico and a square IPS panel of 240x240 (ST7789).
#pragma once

#include <boards/pico.hpp>
#include <display/st7789.hpp>

namespace shade16 {

struct Board : Pico {
    static constexpr const char* name = "pico_st7789";

    using Panel = DcsDisplay<Bus<62'500'000>, st7789_240x240>;
    static constexpr int width_px = Panel::width_px;
    static constexpr int height_px = Panel::height_px;
    SeenOn<Panel> display;
};

}  // namespace shade16
