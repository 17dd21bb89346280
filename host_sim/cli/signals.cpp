#include "host_sim/cli/signals.hpp"

#include <csignal>

#include "host_sim/cli/terminal.hpp"
#include "host_sim/io/atomic_file.hpp"

namespace shade16::host {

namespace {

/// SA_RESETHAND has put the default action back: raised again, the signal ends the program with the status that a
/// shell expects, 128 + its number.
extern "C" void clean_up_and_end(int number) {
    remove_unfinished_files();
    restore_terminal();
    std::raise(number);
}

}  // namespace

void handle_signals() {
    std::signal(SIGPIPE, SIG_IGN);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        sigaction(number, nullptr, &action);
        if (action.sa_handler == SIG_IGN) continue;  // as nohup wants it
        action.sa_handler = clean_up_and_end;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(number, &action, nullptr);
    }
}

}  // namespace shade16::host
