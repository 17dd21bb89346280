// shade16 report: pages about the engine.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode report(const ReportOptions& options);

}  // namespace shade16::host
