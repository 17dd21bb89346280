// The 16-bit normal nearest to a direction.
#pragma once

#include "host_sim/model/double3.hpp"
#include "shade16/num/vec.hpp"

namespace shade16::host {

/// Of the eight ways to round the components up or down, the one that turns the normal least, among those that are at
/// most one step (2^-14) too long or too short: lighting takes a stored normal for a unit vector, so a wrong length is
/// an error like a wrong direction. Rounding to the nearest always satisfies that, so there is a choice.
Normal14 nearest_normal(const Double3& unit);

double angle_degrees(const Double3& unit, Normal14 normal);

}  // namespace shade16::host
