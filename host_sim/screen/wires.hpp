// A panel that hangs on this computer: at which lines, and at which SPI.
#pragma once

#include <string>

#include "boards/linux_spi/spidev.hpp"

namespace shade16::host {

/// Lines are libgpiod's, as boards/linux_spi/find_line.hpp reads them. Those that a panel lacks are empty.
struct Wires {
    std::string command{}, reset{}, backlight{};
    std::string clock{}, data{}, select{};  // bits sent line by line, in place of SPI
    linux_spi::SpidevSettings spi{};
    bool is_dark_at_end = false;   // else the panel shows its last frame on
    std::string devices = "/dev";  // the folder of the lines' chips
};

}  // namespace shade16::host
