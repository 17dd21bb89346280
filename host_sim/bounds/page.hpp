// The report as one page that needs nothing beside it, and as the tables of docs/bounds.md.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bounds/chart.hpp"
#include "host_sim/bounds/vertices.hpp"

namespace shade16::bounds {

struct Report {
    std::vector<Result> results{};
    std::vector<VertexResult> vertices{};  // none in a merged report, which has only their results
};

std::string page(const Report& report);
std::string markdown(const Report& report);

}  // namespace shade16::bounds
