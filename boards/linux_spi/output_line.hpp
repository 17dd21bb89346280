// A line of this computer's that a program drives, over libgpiod 1 or 2: taken by the constructor, released by the destructor.
#pragma once

#include <memory>
#include <string>

#include "boards/linux_spi/gpio_port.hpp"

namespace shade16::linux_spi {

struct LineOptions {
    bool active_low = false;   // on is low
    bool initially = false;    // on or off from the first moment
    std::string consumer = "shade16";  // what gpioinfo says of a line that is in use
    std::string devices = "/dev";
};

/// Every mistake and every refusal is a host::Error: one sentence that names the line.
class OutputLine {
public:
    /// `wanted`: "GPIO25", "25", "gpiochip0:25" or "/dev/gpiochip0:25"; find_line.hpp says what each means.
    explicit OutputLine(const std::string& wanted, const LineOptions& options = {});
    void set(bool on);

private:
    std::string wanted_, chip_;
    std::unique_ptr<gpio::Request> request_;
};

}  // namespace shade16::linux_spi
