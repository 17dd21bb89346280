#include "host_sim/screen/terminal_screen.hpp"

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/half_blocks.hpp"
#include "host_sim/cli/ink.hpp"
#include "host_sim/cli/terminal.hpp"

namespace shade16::host {

TerminalScreen::TerminalScreen() : size_(pixels_of_terminal()) {
    if (is_terminal(STDOUT_FILENO)) print("\033[?25l");
}
TerminalScreen::~TerminalScreen() {
    try {
        print(is_terminal(STDOUT_FILENO) ? "\033[0m\033[?25h\n" : "");
    } catch (const std::exception&) {  // nobody reads any more
    }
}

std::size_t TerminalScreen::send(const Image& frame) {
    std::string text = wants_no_color() ? shades_of_letters(frame) : half_blocks(frame);
    if (is_terminal(STDOUT_FILENO)) {
        text.pop_back();  // a last line's end would scroll a full screen
        if (has_begun_) text = fmt::format("\r\033[{}A", std::max(1, size_.height / 2 - 1)) + text;
    }
    has_begun_ = true;
    print(text);
    return text.size();
}

}  // namespace shade16::host
