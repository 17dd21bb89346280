#include "tests/linux/guest/watched.hpp"

#include <sys/wait.h>

#include <csignal>

#include "tests/displays/turned.hpp"
#include "tests/linux/guest/recorded_panel.hpp"

namespace shade16::linux_spi {

namespace {

volatile std::sig_atomic_t child = 0;
extern "C" void pass_on(int number) { kill(child, number); }

/// Its end, if that has come.
bool has_ended(int& code) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) == 0) return false;
    code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return true;
}

void print_what_is_shown(RecordedPanel& panel) {
    if (panel.model().is_on()) panel.model().end();  // a display that was switched off at the end misses nothing
    const displays::Seen seen = displays::turned(panel.model().seen(), {(4 - guest_orientation.quarter_turns) & 3});
    std::printf("complaint: %s\n", panel.model().complaint().empty() ? "none" : panel.model().complaint().c_str());
    std::printf("backlight: %s, the display is %s\n", panel.lights().c_str(), panel.model().is_on() ? "on" : "off");
    std::printf("seen %08X\n", static_cast<unsigned>(hash_of(seen.pixels)));
}

}  // namespace

int become(const std::vector<std::string>& command) {
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));  // execvp leaves them as they are
    words.push_back(nullptr);
    execvp(words[0], words.data());
    throw host::io_error("{} cannot be run: {}.", command[0], std::strerror(errno));
}

int watch(const std::vector<std::string>& command) {
    constexpr unsigned glance_us = 2000;  // the record holds two frames
    RecordedPanel panel;
    std::fflush(stdout);
    child = fork();
    if (child == 0) return become(command);
    std::signal(SIGTERM, pass_on);
    bool is_lit = false;
    for (int code = 0;; usleep(glance_us)) {
        const bool is_last = has_ended(code);
        panel.catch_up();
        if (!is_lit && !panel.lights().empty()) std::puts("lit"), std::fflush(stdout), is_lit = true;
        if (!is_last) continue;
        print_what_is_shown(panel);
        return code;
    }
}

}  // namespace shade16::linux_spi
