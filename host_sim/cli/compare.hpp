// shade16 compare: the engine against double precision.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode compare(const CompareOptions& options);

}  // namespace shade16::host
