// What the guest's program does over the kernel's own spidev.
#pragma once

#include <string>

namespace shade16::linux_spi {

/// Shows the torus once. `how`: mode_0, mode_3, or untold: in mode 0 as where /sys does not tell how large spidev's buffer is.
int show_on_spidev(const std::string& device, const std::string& how);
/// Draws until it is stopped, by a signal or a failure.
int draw_on_spidev(const std::string& device);
/// Opens the device in a mode, which may be one that it does not have.
int try_spidev(const std::string& device, unsigned mode);

}  // namespace shade16::linux_spi
