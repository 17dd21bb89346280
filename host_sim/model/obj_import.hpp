// Wavefront OBJ, with its MTL libraries.
#pragma once

#include <optional>
#include <string>

#include "host_sim/model/model.hpp"

namespace shade16::host {

/// Reads a model. Faces of up to 255 corners become triangles; equal position, normal, colour and place
/// in the texture make one vertex.
///
/// Where the file gives no normal (or one of zero length), a vertex gets the normalised sum of the unit normals of all
/// faces at its position. Position, not index: the teapot has 792 v lines and 529 distinct positions, and its seams
/// must not show. Each face counts once, whatever its area and number of corners. Where the file has smoothing groups, faces
/// are smooth within their group, and flat where it is off.
///
/// With a crease angle, from 0 to 180 degrees, all normals are made anew from the faces: those that meet at a greater angle
/// keep a hard edge, each with a vertex of its own.
///
/// Texture coordinates are read where a material has a texture, or everywhere if `with_texcoords`; a vertex without any has (0, 0).
///
/// Throws input_error for a file that is missing, unreadable, without a drawable face, or wrong in one of its lines.
Model import_obj(const std::string& path, std::optional<double> crease_degrees = {}, bool with_texcoords = false);

}  // namespace shade16::host
