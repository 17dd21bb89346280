// Which triangle each pixel shows, as the engine itself decides it.
#pragma once

#include <cstdint>
#include <vector>

#include "shade16/scene/scene.hpp"
#include "shade16/pipeline/transform.hpp"

namespace shade16::host {

struct FaceId {
    uint32_t object = 0, face = 0;
    bool covered = false;
};

/// Draws the scene with every face in a colour of its own, unlit, through the same pipeline: coverage and depth test are
/// then the engine's, to the bit, and the colour names the face.
std::vector<FaceId> winning_faces(const Scene& scene, const Frame& frame, Viewport viewport);

}  // namespace shade16::host
