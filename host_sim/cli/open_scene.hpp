// What a command draws: a scene file, or a model with a scene fitted around it.
#pragma once

#include <memory>
#include <optional>

#include "host_sim/cli/options.hpp"
#include "host_sim/engine/model_scene.hpp"
#include "host_sim/error.hpp"
#include "host_sim/scene_file/description.hpp"

namespace shade16::host {

struct OpenScene {
    std::unique_ptr<AnimatedScene> scene{};
    std::optional<FitFigures> fit{};  // of a model
    SceneDescription description{};
};

/// A scene file's own output settings go to those options that were not on the command line.
OpenScene open_scene(RenderOptions& options);
OpenScene open_scene(CompareOptions& options);
OpenScene open_scene(InfoOptions& options);
OpenScene open_scene(const PreviewOptions& options, Viewport size);

/// A crease angle on the command line belongs to a model.
Error crease_beside_scene_file();

/// The scene as a scene file, with the options as its output.
std::string dumped(const OpenScene& scene, const RenderOptions& options);

}  // namespace shade16::host
