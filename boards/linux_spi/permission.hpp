// A device that this user may not open: which group may, and the command that mends it.
#pragma once

#include "host_sim/error.hpp"

namespace shade16::linux_spi {

/// `what` begins the sentence: what the device was opened for. `usual_group` is whom such devices belong to where root did not keep them.
host::Error permission_denied(const std::string& what, const std::string& device, const std::string& usual_group, const std::string& groups = "/etc/group");

}  // namespace shade16::linux_spi
