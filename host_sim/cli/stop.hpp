// Ctrl-C and its like as a question: for work that must put something back before the program ends.
#pragma once

#include <chrono>

namespace shade16::host {

/// While it lives, SIGINT, SIGTERM and SIGHUP are remembered instead of ending the program. A second one ends it.
class StopOnSignal {
public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    bool is_asked() const;
    /// Returns earlier when somebody asks.
    void wait_until(std::chrono::steady_clock::time_point time) const;
};

}  // namespace shade16::host
