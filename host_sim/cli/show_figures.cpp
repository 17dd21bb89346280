#include "host_sim/cli/show_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/ink.hpp"

namespace shade16::host {

namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration time) { return std::max(std::chrono::duration<double>(time).count(), 1e-9); }

void say(const std::string& text) { print_beside("-", text); }  // on standard error

}  // namespace

std::string figures_text(const ScreenFigures& sum, Clock::duration time, std::size_t lost) {
    const double frames = static_cast<double>(sum.frames);
    std::string text = fmt::format("shown: {} in {:.1f} s, {:.1f} a second; {:.0f} bytes a frame; sending took {:.0f} % of the time\n",
                                   counted(static_cast<std::size_t>(sum.frames), "frame", "frames"), seconds(time), frames / seconds(time),
                                   static_cast<double>(sum.bytes) / std::max(frames, 1.0), 100 * seconds(sum.sending) / seconds(time));
    if (lost != 0) text += fmt::format("lost: {}, while the device was away\n", counted(lost, "frame", "frames"));
    return text;
}

LiveFigures::LiveFigures(bool is_wanted) : is_shown_(is_wanted && is_terminal(STDERR_FILENO)) {}

void LiveFigures::clear() {
    if (is_written_) say("\r\033[K");
    is_written_ = false;
}

void LiveFigures::tell(const ScreenFigures& sum) {
    const auto time = Clock::now() - since_;
    if (!is_shown_ || time < std::chrono::seconds(1)) return;
    say(fmt::format("\r\033[K{:.1f} frames a second, sending takes {:.0f} % of the time", static_cast<double>(sum.frames - before_.frames) / seconds(time),
                    100 * seconds(sum.sending - before_.sending) / seconds(time)));
    is_written_ = true;
    since_ = Clock::now(), before_ = sum;
}

}  // namespace shade16::host
