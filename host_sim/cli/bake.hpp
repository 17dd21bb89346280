// shade16 bake: a model or a scene to a C++ header.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode bake(const BakeOptions& options);

}  // namespace shade16::host
