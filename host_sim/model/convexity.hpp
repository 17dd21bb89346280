// Convexity, proved: a convex mesh drawn alone needs no depth buffer, because none of its front faces hides another.
#pragma once

#include <span>

#include "shade16/scene/mesh.hpp"

namespace shade16::host {

/// Closed (each edge in exactly two faces, once each way; vertices at one position are one) and with no vertex in front
/// of any face's plane. Exact: 64-bit integers. Faces may share a plane. A sphere whose vertices were rounded is rarely
/// convex: its quads are no longer flat, and half of them bend inwards.
/// Cost    faces x distinct positions, less as soon as one vertex is in front.
bool is_convex(std::span<const Position16> positions, std::span<const Triangle> triangles);

}  // namespace shade16::host
