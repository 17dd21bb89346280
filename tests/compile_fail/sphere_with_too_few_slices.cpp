// EXPECT: a sphere has at least 3 slices and 2 stacks
#include "shade16/scene/shapes.hpp"

constexpr shade16::Mesh mesh = shade16::sphere<2, 2>.mesh();
