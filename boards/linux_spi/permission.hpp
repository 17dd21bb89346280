// A device that this user may not open: which group may, and the command that mends it.
#pragma once

#include "host_sim/error.hpp"

namespace shade16::linux_spi {

/// `what` is what the device was opened for: a line.
host::Error permission_denied(const std::string& line, const std::string& device, const std::string& groups = "/etc/group");

}  // namespace shade16::linux_spi
