// The figures of each command as one JSON object, for scripts. `schema` grows when a key changes its meaning.
#pragma once

#include <string>
#include <vector>

#include "host_sim/cli/options.hpp"
#include "host_sim/engine/model_scene.hpp"
#include "host_sim/gallery/plate.hpp"
#include "host_sim/report/compare.hpp"
#include "host_sim/report/survey.hpp"
#include "host_sim/scene_file/loaded_scene.hpp"

namespace shade16::host {

/// `fit` is nullptr where nothing was fitted.
std::string render_json(const RenderOptions& options, const FitFigures* fit, int frames,
                        const std::vector<std::string>& warnings);

std::string compare_json(const CompareOptions& options, const std::vector<Comparison>& tiers,
                         const AnimatedScene& scene);

std::string bake_json(const BakeOptions& options, const BakedModel& baked);
std::string bake_json(const BakeOptions& options, const LoadedScene& scene);

std::string info_json(const Survey& survey, const std::vector<std::string>& warnings);

std::string materials_json(const MaterialsOptions& options);

std::string gallery_json(const std::vector<Plate>& plates);

}  // namespace shade16::host
