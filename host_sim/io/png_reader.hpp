// PNG files as pictures of 8 bits a channel.
#pragma once

#include <string>

#include "host_sim/io/image.hpp"

namespace shade16::host {

/// Reads a PNG of any kind; transparency is left out. Throws Error with a sentence for a file that is missing, no PNG,
/// damaged, or larger than 4096 pixels a side.
Image read_png(const std::string& path);

}  // namespace shade16::host
