// shade16 render: a model to frames.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode render(const RenderOptions& options);

}  // namespace shade16::host
