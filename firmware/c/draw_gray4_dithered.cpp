#include "draw.hpp"

SHADE16_C_DRAW(gray4_dithered, shade16::Dithered<shade16::Gray4, shade16::bayer4>)
