#include "draw.hpp"

SHADE16_C_DRAW(mono1_dithered, shade16::Dithered<shade16::Mono1, shade16::bayer4>)
