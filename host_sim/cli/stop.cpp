#include "host_sim/cli/stop.hpp"

#include <array>
#include <csignal>
#include <thread>

namespace shade16::host {

namespace {

constexpr std::array numbers{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t asked = 0;
std::array<struct sigaction, numbers.size()> before{};

/// The second one finds what was there before, which ends the program.
extern "C" void remember(int) {
    asked = 1;
    for (std::size_t i = 0; i < numbers.size(); ++i) sigaction(numbers[i], &before[i], nullptr);
}

}  // namespace

StopOnSignal::StopOnSignal() {
    asked = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        struct sigaction action {};
        action.sa_handler = remember;
        sigaction(numbers[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN) sigaction(numbers[i], &action, nullptr);  // as nohup wants it
    }
}

StopOnSignal::~StopOnSignal() {
    for (std::size_t i = 0; i < numbers.size(); ++i) sigaction(numbers[i], &before[i], nullptr);
}

bool StopOnSignal::is_asked() const { return asked != 0; }

void StopOnSignal::wait_until(std::chrono::steady_clock::time_point time) const {
    constexpr std::chrono::milliseconds glance{10};
    while (!is_asked() && std::chrono::steady_clock::now() + glance < time) std::this_thread::sleep_for(glance);
    if (!is_asked()) std::this_thread::sleep_until(time);
}

}  // namespace shade16::host
