// Ctrl-C and its kin for a loop of frames: the signal is only noted, so that destructors release every line.
#pragma once

#include <csignal>

namespace shade16::linux_spi {

/// Thrown by a loop that was asked to stop.
struct Stopped {
    int signal = 0;
    const char* name() const;  // "SIGTERM"
};

/// From its constructor to its destructor SIGINT, SIGTERM and SIGHUP ask to stop; a third one ends the program at once. One object at a
/// time.
class StopOnSignal {
public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    /// The signal that asked, or 0.
    int asked() const;
    void throw_if_asked() const {
        if (const int signal = asked(); signal != 0) throw Stopped{signal};
    }
};

/// Ends the program as the signal would have: a shell sees 128 and its number. For main, once all is cleaned up.
void end_by(const Stopped& stopped);

}  // namespace shade16::linux_spi
