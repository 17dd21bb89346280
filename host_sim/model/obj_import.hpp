// Wavefront OBJ, with its MTL libraries.
#pragma once

#include <string>

#include "host_sim/model/model.hpp"

namespace shade16::host {

/// Reads a model. Faces of up to 255 corners become triangles; equal position, normal and colour make one vertex.
///
/// Where the file gives no normal (or one of zero length), a vertex gets the normalised sum of the unit normals of all
/// faces at its position. Position, not index: the teapot has 792 v lines and 529 distinct positions, and its seams
/// must not show. Each face counts once, whatever its area and number of corners; smoothing groups are not looked at.
///
/// Throws input_error for a file that is missing, unreadable, without a drawable face, or wrong in one of its lines.
Model import_obj(const std::string& path);

}  // namespace shade16::host
