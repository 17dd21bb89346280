#include "draw.hpp"

SHADE16_C_DRAW(rgb565_swapped, shade16::Rgb565Swapped)
