#include "draw.hpp"

SHADE16_C_DRAW(gray4, shade16::Gray4)
