// shade16 info: what a model needs and takes, without drawing it.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode info(const InfoOptions& options);

}  // namespace shade16::host
