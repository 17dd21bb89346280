// The luma along a picture's middle row, as a plot of the same width.
#pragma once

#include "host_sim/io/image.hpp"

namespace shade16::host {

/// Black is at the bottom, white at the top; lines mark every quarter.
Image profile_of_middle_row(const Image& picture, int height);

}  // namespace shade16::host
