#include "host_sim/cli/terminal_screen.hpp"

#include <algorithm>

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/half_blocks.hpp"
#include "host_sim/cli/ink.hpp"

namespace shade16::host {

std::size_t TerminalScreen::send(const Image& frame) {
    if (!held_) held_.emplace();
    std::string text = wants_no_color() ? shades_of_letters(frame) : half_blocks(frame);
    if (is_terminal(STDOUT_FILENO)) {
        text.pop_back();  // a last line's end would scroll a full screen
        const bool is_first = shown_height_ == 0, same = frame.width == shown_width_ && frame.height == shown_height_;
        if (!is_first && !same) text = "\033[0m\033[2J\033[H" + text;  // resized: what is there no longer fits
        if (same) text = (frame.height > 2 ? fmt::format("\r\033[{}A", frame.height / 2 - 1) : "\r") + text;
    }
    shown_width_ = frame.width, shown_height_ = frame.height;
    print(text);
    return text.size();
}

}  // namespace shade16::host
