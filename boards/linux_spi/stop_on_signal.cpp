#include "boards/linux_spi/stop_on_signal.hpp"

#include <array>

namespace shade16::linux_spi {

namespace {

constexpr int patience = 3;

volatile std::sig_atomic_t asked_by = 0;
volatile std::sig_atomic_t times = 0;

// What each signal did before.
constexpr std::array numbers{SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, numbers.size()> before;

void put_back() {
    for (std::size_t i = 0; i < numbers.size(); ++i) sigaction(numbers[i], &before[i], nullptr);
}

/// A second one may be the same one: `timeout` and some shells signal a program and its group.
extern "C" void note_signal(int number) {
    asked_by = number;
    times = times + 1;
    if (times < patience) return;
    put_back();  // which may clean a terminal up
    std::raise(number);
}

}  // namespace

StopOnSignal::StopOnSignal() {
    asked_by = 0;
    times = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        sigaction(numbers[i], nullptr, &before[i]);
        if (before[i].sa_handler == SIG_IGN) continue;  // as nohup wants it
        struct sigaction action {};
        action.sa_handler = note_signal;
        sigaction(numbers[i], &action, nullptr);
    }
}

StopOnSignal::~StopOnSignal() { put_back(); }

int StopOnSignal::asked() const { return asked_by; }

const char* Stopped::name() const { return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP"; }

void end_by(const Stopped& stopped) {
    std::signal(stopped.signal, SIG_DFL);
    std::raise(stopped.signal);
}

}  // namespace shade16::linux_spi
