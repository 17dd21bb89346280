// A fitted model as a scene description: where a scene file of one's own may begin.
#pragma once

#include <string>

#include "host_sim/engine/model_scene.hpp"
#include "host_sim/scene_file/description.hpp"

namespace shade16::host {

/// `path` is the model's. The scene draws the very frames that the ModelScene does.
SceneDescription describe(const ModelScene& scene, const std::string& path);

}  // namespace shade16::host
