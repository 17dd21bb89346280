// A panel at this computer's lines, with its pixels through spidev or line by line.
#pragma once

#include <memory>

#include "host_sim/screen/panel_by_name.hpp"
#include "host_sim/screen/screen.hpp"
#include "host_sim/screen/wires.hpp"

namespace shade16::host {

/// Takes every line and the device, and switches the panel on. Throws input_error or io_error with what is missing and what brings it.
std::unique_ptr<Screen> wired_screen(const Wires& wires, const Panel& panel, Orientation orientation,
                                     linux_spi::SystemCalls& system = linux_spi::system_calls());

}  // namespace shade16::host
