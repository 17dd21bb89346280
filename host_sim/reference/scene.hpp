// The scene as the reference draws it: the core's scene, with meshes in double precision. A mesh is either the core's
// quantised one, exactly, or the file's own before quantisation.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/reference/values.hpp"

namespace shade16::reference {

/// Corners by index; not limited to 16 bits, since a file's mesh is not.
struct Triangle {
    uint32_t a = 0, b = 0, c = 0;
};

struct Mesh {
    std::vector<glm::dvec3> positions{}, normals{}, colors{};
    std::vector<Triangle> triangles{};
    std::vector<glm::dvec2> texcoords{};
};

/// The quantised mesh, each value exact.
Mesh value(const shade16::Mesh& mesh);

struct Scene {
    const shade16::Scene& values;  // camera, lights, materials, poses
    std::vector<Mesh> meshes{};    // one an object
};

/// The reference's view of a core scene, on the same integers.
Scene value(const shade16::Scene& scene);

}  // namespace shade16::reference
