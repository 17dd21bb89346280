// A scene as a scene file again: every default written out, every number the shortest that reads as the same bits.
#pragma once

#include <string>

#include "host_sim/scene_file/description.hpp"

namespace shade16::host {

/// Reading it gives the same scene. Names of models are absolute, so that it can be read from anywhere.
std::string dump_scene(const SceneDescription& scene);

}  // namespace shade16::host
