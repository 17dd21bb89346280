// The terminal as something to draw on: its size, its keys, and how it is left behind.
#pragma once

#include "shade16/pipeline/transform.hpp"

namespace shade16::host {

/// Two pixels a character, one row of text kept free; 80 x 24 characters where there is no terminal.
Viewport pixels_of_terminal();

/// Hides the cursor and reads keys without Return, for as long as it lives. Does nothing without a terminal.
class TerminalHeld {
public:
    TerminalHeld();
    ~TerminalHeld();
    TerminalHeld(const TerminalHeld&) = delete;
    TerminalHeld& operator=(const TerminalHeld&) = delete;
};

/// Shows the cursor again. Async-signal-safe, for the handler of Ctrl-C; nothing happens when nothing is held.
void restore_terminal() noexcept;

/// Waits so long, and says whether 'q' was typed meanwhile.
bool is_quit_typed(int milliseconds);

}  // namespace shade16::host
