// A scene file, read: docs/scene-file.md has every key.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/scene_file/description.hpp"

namespace shade16::host {

/// Throws input_error, "scene.toml:12: ...", for whatever is no scene; the meshes are not opened yet.
SceneDescription read_scene(const std::string& path);
SceneDescription read_scene_text(std::string_view text, const std::string& path);

}  // namespace shade16::host
