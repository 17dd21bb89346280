#include "host_sim/cli/terminal.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string_view>

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "host_sim/cli/ink.hpp"
#include "shade16/target/band.hpp"

namespace shade16::host {

namespace {

// Where a signal handler can reach them.
std::atomic<bool> is_cursor_hidden{false}, are_keys_raw{false};
termios keys_before{};

/// A program in the background that set the terminal would be stopped, in a signal handler for good.
bool is_keyboard_ours() { return tcgetpgrp(STDIN_FILENO) == getpgrp(); }

void say(std::string_view text) {
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0) return;  // the terminal is gone: nothing to restore
}

}  // namespace

Viewport pixels_of_terminal() {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
        size.ws_col = 80, size.ws_row = 24;
    return {std::clamp<int32_t>(size.ws_col, 1, max_target_px),
            2 * std::clamp<int32_t>(size.ws_row - 1, 1, max_target_px / 2)};
}

TerminalHeld::TerminalHeld() {
    if (!is_terminal(STDOUT_FILENO)) return;
    if (is_keyboard_ours() && tcgetattr(STDIN_FILENO, &keys_before) == 0) {
        termios raw = keys_before;
        raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        raw.c_cc[VQUIT] = _POSIX_VDISABLE;  // it would leave all as it is
        raw.c_cc[VSUSP] = _POSIX_VDISABLE;  // a stopped program would leave the shell without echo
        are_keys_raw = true;
        tcsetattr(STDIN_FILENO, TCSANOW, &raw);
    }
    is_cursor_hidden = true;
    say("\033[?25l");
}

TerminalHeld::~TerminalHeld() { restore_terminal(); }

void restore_terminal() noexcept {
    const int before = errno;
    if (are_keys_raw.exchange(false) && is_keyboard_ours()) tcsetattr(STDIN_FILENO, TCSANOW, &keys_before);
    if (is_cursor_hidden.exchange(false)) say("\033[0m\033[?25h\n");
    errno = before;
}

bool is_quit_typed(int milliseconds) {
    pollfd keys{is_keyboard_ours() ? STDIN_FILENO : -1, POLLIN, 0};
    if (poll(&keys, 1, milliseconds) <= 0) return false;
    char key = 0;
    if (::read(STDIN_FILENO, &key, 1) <= 0) return true;  // nobody can type any more
    return key == 'q' || key == 'Q';
}

}  // namespace shade16::host
