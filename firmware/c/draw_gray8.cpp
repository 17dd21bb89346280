#include "draw.hpp"

SHADE16_C_DRAW(gray8, shade16::Gray8)
