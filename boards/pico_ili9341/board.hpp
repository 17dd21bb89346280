// Raspberry Pi Pico and a panel of 320x240 (ILI9341), lying on its side.
#pragma once

#include <boards/pico.hpp>
#include <display/ili9341.hpp>

namespace shade16 {

struct Board : Pico {
    static constexpr const char* name = "pico_ili9341";

    using Panel = DcsDisplay<Bus<32'000'000>, ili9341, Orientation{1}>;
    static constexpr int width_px = Panel::width_px;
    static constexpr int height_px = Panel::height_px;
    SeenOn<Panel> display;
};

}  // namespace shade16
