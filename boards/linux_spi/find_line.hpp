// Where a line is, of what a person calls it.
#pragma once

#include <string>
#include <vector>

#include "boards/linux_spi/gpio_port.hpp"

namespace shade16::linux_spi {

struct Place {
    std::string chip{};  // a device
    unsigned offset = 0;
};

/// `wanted` is a name ("GPIO25"), a number ("25": the line GPIO25, else that offset on the chip whose label begins with pinctrl-), or a
/// chip and an offset ("gpiochip0:25", "/dev/gpiochip0:25"). `devices` is the folder of the chips. Throws host::Error.
Place find_line(const std::string& wanted, const std::string& devices);

/// The chips of a folder in the order of their numbers, without those that are another name for one.
std::vector<std::string> chips_of(const std::string& devices);

/// Opens a chip, or throws host::Error about the line for whose sake it was opened.
gpio::Chip open_chip(const std::string& path, const std::string& wanted, const std::string& devices);

}  // namespace shade16::linux_spi
