// A frame as text: each character shows two pixels, the upper as its colour and the lower as its background.
#pragma once

#include <string>

#include "host_sim/io/image.hpp"

namespace shade16::host {

/// One line of text for two rows of pixels, each ended by the normal colours and "\n".
std::string half_blocks(const Image& image);

/// The same size in letters alone, for who wants no colour.
std::string shades_of_letters(const Image& image);

}  // namespace shade16::host
