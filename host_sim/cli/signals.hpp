// Ctrl-C and a closed pipe.
#pragma once

namespace shade16::host {

/// Stopped from outside, the program removes what it had begun to write; a closed pipe becomes ClosedPipe.
void handle_signals();

}  // namespace shade16::host
