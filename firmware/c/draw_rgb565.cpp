#include "draw.hpp"

SHADE16_C_DRAW(rgb565, shade16::Rgb565)
