// A polygon in space: its normal, and triangles that cover it, also where it is concave. (tinyobjloader splits a quad
// at its shorter diagonal, which lies outside of an arrowhead, and its ear clipping takes a sign from the wrong area.)
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/model/double3.hpp"

namespace shade16::host {

/// Twice the area, along the normal; of a warped polygon the mean.  Source: Newell's method, about the first corner.
Double3 area_vector(std::span<const Double3> corners);

/// corners - 2 triangles of corner numbers, turning as the polygon does. Cuts the ear with the shortest diagonal first.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Double3> corners);

/// No area worth drawing: thinner than 1e-10 of its longest edge.
bool is_degenerate(const Double3& a, const Double3& b, const Double3& c);

}  // namespace shade16::host
