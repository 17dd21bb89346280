// Every panel that has a driver.
#pragma once

#include <display/gc9a01.hpp>
#include <display/ili9341.hpp>
#include <display/st7735.hpp>
#include <display/st7789.hpp>

namespace shade16 {

inline constexpr DcsPanel all_panels[] = {ili9341,          st7789,         st7789_240x240, st7789_135x240,        st7735_black_tab,
                                          st7735_green_tab, st7735_128x128, st7735_80x160,  st7735_80x160_plug_in, gc9a01};

}  // namespace shade16
