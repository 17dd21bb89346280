// LoadedMesh: a mesh of a scene file, read or made.
#pragma once

#include <optional>

#include "host_sim/model/quantize.hpp"
#include "host_sim/reference/scene.hpp"
#include "host_sim/scene_file/description.hpp"

namespace shade16::host {

struct LoadedMesh {
    std::optional<Model> model{};  // as the file has it; none for a built-in shape
    BakedModel baked{};

    /// What the file says of each baked part, unrounded; a built-in shape is exact as it is.
    std::vector<reference::Mesh> originals() const;
};

/// `scene_path` is the scene file: models are beside it. `is_textured`: with texture coordinates. Throws input_error with the
/// scene file's line.
LoadedMesh load_mesh(const MeshDescription& mesh, const std::string& scene_path, bool is_textured);

/// Whether no front face hides another, though the surface need not be closed: every vertex lies on or behind every
/// face's plane, and no two faces in one plane overlap. Drawn alone, such a mesh needs no depth buffer.
bool hides_nothing_of_itself(const Mesh& mesh);

}  // namespace shade16::host
