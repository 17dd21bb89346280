// shade16 materials: the classic table, as text or as a picture.
#pragma once

#include "host_sim/cli/options.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

ExitCode materials(const MaterialsOptions& options);

}  // namespace shade16::host
