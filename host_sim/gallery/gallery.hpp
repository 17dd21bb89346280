// The gallery: every picture of docs/gallery.md, drawn and measured.
#pragma once

#include <string>
#include <vector>

#include "host_sim/gallery/plate.hpp"

namespace shade16::host {

/// Draws them all from the project's assets. Throws as reading scene files does.
std::vector<Plate> gallery_plates(const std::string& assets);

}  // namespace shade16::host
