// From a Model to what lies in flash: 16-bit positions on a lattice, 16-bit normals, 16-bit indices in cache order.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/model/model.hpp"
#include "shade16/scene/mesh.hpp"

namespace shade16::host {

struct BakedPart {
    std::string name{};
    std::vector<Position16> positions{};
    std::vector<Normal14> normals{};
    std::vector<Rgb> colors{};  // empty, or one a vertex
    std::vector<TexCoord16> texcoords{};  // empty, or one a vertex
    int8_t texcoord_bits = 14;
    std::vector<Triangle> triangles{};
    Material material{};
    MaterialMaps maps{};
    bool convex = false;

    std::size_t flash_bytes() const;
};

struct BakedModel {
    std::string source{};  // the file's name without its directory
    Vec3 centre{};
    int8_t fraction_bits = 14;
    std::vector<BakedPart> parts{};

    double max_position_error = 0;  // a distance, in the model's units
    double max_normal_error_degrees = 0;
    std::size_t degenerate_triangles = 0;  // lost their area by rounding, and were dropped
    std::vector<std::string> warnings{};   // the model's, and what rounding added

    std::size_t vertex_count() const;
    std::size_t triangle_count() const;
    std::size_t flash_bytes() const;  // of the arrays
};

/// Vertices that a post-transform cache is thought to hold; the order is good for larger ones, too.
inline constexpr unsigned int vertex_cache_entries = 16;

/// One part a material; centre and scale are common, so that parts meet exactly.
/// Error   half a lattice step a coordinate: at most 2^-16 of the longest edge of the model's box. None at all when
///         every coordinate is a multiple of the step; such a model keeps its origin as the centre when it fits.
/// Texture coordinates have as many fraction bits as the largest of a part allows: 2^-15 off at most from 0 to 1.
/// Throws input_error when a part has more than 65535 vertices, or when nothing is left after rounding.
BakedModel quantize(const Model& model);

/// A view of a part; it lives as long as the BakedModel does.
Mesh mesh_of(const BakedModel& model, std::size_t part);

}  // namespace shade16::host
