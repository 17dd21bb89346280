// Model: triangles from a file, in double precision, before anything is rounded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/model/double3.hpp"
#include "host_sim/model/texture_file.hpp"
#include "shade16/scene/material.hpp"

namespace shade16::host {

/// The triangles of one material.
struct ModelPart {
    std::string name{};
    Material material{};
    MaterialMaps maps{};  // what its textures look at
    std::vector<std::string> notes{};  // what the MTL asks for and does not get, such as "map_Ks wall.png"
    std::vector<std::array<uint32_t, 3>> triangles{};
};

struct Model {
    std::string source{};  // the file's name without its directory
    std::vector<Double3> positions{};
    std::vector<Double3> normals{};  // unit length, one a position
    std::vector<Double3> colors{};   // one a position, or empty
    std::vector<std::array<double, 2>> texcoords{};  // one a position, or empty; only where something is textured
    bool texcoords_for_all_parts = false;            // not only for those with a texture of their own
    std::vector<ModelPart> parts{};

    std::size_t degenerate_triangles = 0;  // left out
    std::size_t replaced_normals = 0;      // of the file's, without a direction
    std::vector<std::string> warnings{};   // sentences
};

/// The neutral grey of what has no material: mild white highlights.
inline Material default_material() {
    Material material;
    material.specular = rgb(0x666666);
    return material;
}

}  // namespace shade16::host
