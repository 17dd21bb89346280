// A built-in shape as the expression that makes the compiler build it.
#pragma once

#include <string>

#include "host_sim/scene_file/description.hpp"

namespace shade16::host {

/// Such as `shade16::sphere<32, 16>.mesh()`; empty for what the core has no expression for, and for shapes that are too
/// large for a compiler to build within its usual limits.
std::string shape_text(const MeshDescription& mesh, bool is_textured);

}  // namespace shade16::host
