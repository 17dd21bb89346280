// The result of a comparison, for somebody who has never seen one: units, what is promised, and a verdict in a word.
#pragma once

#include <string>
#include <vector>

#include "host_sim/cli/ink.hpp"
#include "host_sim/cli/options.hpp"
#include "host_sim/engine/animated_scene.hpp"
#include "host_sim/report/compare.hpp"

namespace shade16::host {

/// "kept", "broken", or "suspect": a reference that never differs is not compared with.
const char* verdict_of(const std::vector<Comparison>& tiers);

std::string comparison_text(const std::vector<Comparison>& tiers, const AnimatedScene& scene,
                            const CompareOptions& options, const Ink& ink);

}  // namespace shade16::host
