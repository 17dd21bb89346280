// What `show` says of its frames: how many a second, and how much of the time the bus took.
#pragma once

#include <chrono>
#include <string>

#include "host_sim/screen/screen.hpp"

namespace shade16::host {

/// Those of all frames, as a line; `lost` are those that were drawn while the device was away.
std::string figures_text(const ScreenFigures& sum, std::chrono::steady_clock::duration time, std::size_t lost);

/// Those of the last second, once a second on standard error, rewritten in place; on a terminal alone.
class LiveFigures {
public:
    explicit LiveFigures(bool is_wanted);
    ~LiveFigures() { clear(); }
    LiveFigures(const LiveFigures&) = delete;
    LiveFigures& operator=(const LiveFigures&) = delete;

    void tell(const ScreenFigures& sum);
    /// Before anything else is written.
    void clear();

private:
    bool is_shown_, is_written_ = false;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
    ScreenFigures before_{};
};

}  // namespace shade16::host
