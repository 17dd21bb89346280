// Heat maps: a difference as a colour, from black through red and yellow to white at the end of the scale.
#pragma once

#include "host_sim/gallery/canvas.hpp"
#include "host_sim/gallery/difference.hpp"

namespace shade16::host {

/// The end of every scale, and what it is: mediump promises no more of a vertex.
inline constexpr double heat_scale_levels = mediump::promise.to_exponent_128.micro / 1e6;

/// What RGB565 rounds by at most, half a code of red and blue.
inline constexpr double half_code_levels = 255.0 / 31 / 2;

/// White is at or beyond the end; blue is what only one of both engines drew.
Image heat_map(const ReferenceDifference& difference);

/// The colours with their numbers and what they mean, in one line.
Image heat_scale();

}  // namespace shade16::host
