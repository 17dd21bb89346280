// The classic materials as a sheet of lit spheres, each with its name below.
#pragma once

#include <optional>
#include <string_view>

#include "host_sim/gallery/difference.hpp"
#include "host_sim/io/image.hpp"
#include "shade16/shade16.hpp"

namespace shade16::host {

/// Six by four. `swatch` is the size of one sphere's picture; a cell is never narrower than its name.
Image material_sheet(Viewport swatch, std::string_view tier, std::optional<Shading> shading);

/// The same sheet of heat maps, in mediump; `all` becomes the figures of all of them.
Image material_error_sheet(Viewport swatch, Shading shading, ReferenceDifference& all);

/// The size of the whole sheet.
Viewport material_sheet_size(Viewport swatch);

}  // namespace shade16::host
