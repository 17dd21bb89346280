// A program of any kind, watched from the panel's side: what its lines did, and what the display shows when it has ended.
#pragma once

#include <string>
#include <vector>

namespace shade16::linux_spi {

/// Runs a command while the record of the lines is read, says "lit" when the backlight goes on, and passes SIGTERM on. Returns the command's
/// exit code, 128 and the signal's number where one ended it.
int watch(const std::vector<std::string>& command);

/// Becomes the command.
int become(const std::vector<std::string>& command);

}  // namespace shade16::linux_spi
