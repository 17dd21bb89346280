// shade16 preview: a model turning in the terminal.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode preview(const PreviewOptions& options);

}  // namespace shade16::host
