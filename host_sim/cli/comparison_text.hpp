// The result of a comparison, for somebody who has never seen one: units, what is promised, and a verdict in a word.
#pragma once

#include <string>
#include <vector>

#include "host_sim/cli/options.hpp"
#include "host_sim/engine/model_scene.hpp"
#include "host_sim/report/compare.hpp"

namespace shade16::host {

std::string comparison_text(const std::vector<Comparison>& tiers, const ModelScene& scene,
                            const CompareOptions& options);

}  // namespace shade16::host
