// The report as one page that needs nothing beside it, and as the tables of docs/bounds.md.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bounds/vertices.hpp"

namespace shade16::bounds {

/// `vertices` may be empty: a merged report has only their results.
std::string page(const std::vector<Result>& results, const std::vector<VertexResult>& vertices);

std::string markdown(const std::vector<Result>& results, const std::vector<VertexResult>& vertices);

}  // namespace shade16::bounds
