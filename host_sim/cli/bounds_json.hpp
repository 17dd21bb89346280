// bounds.json: what the report of the bounds leaves for scripts, and for the merging of shards.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bounds/result.hpp"

namespace shade16::host {

std::string bounds_json(const std::vector<bounds::Result>& results);

/// Throws io_error when the file cannot be read, and input_error when it is no such file.
std::vector<bounds::Result> read_bounds_json(const std::string& path);

}  // namespace shade16::host
