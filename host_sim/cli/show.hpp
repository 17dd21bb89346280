// shade16 show: frames on a panel that hangs on this computer, on its framebuffer or in the terminal.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode show(const ShowOptions& options);

}  // namespace shade16::host
