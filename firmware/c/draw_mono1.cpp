#include "draw.hpp"

SHADE16_C_DRAW(mono1, shade16::Mono1)
