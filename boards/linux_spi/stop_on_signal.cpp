#include "boards/linux_spi/stop_on_signal.hpp"

namespace shade16::linux_spi {

namespace {

volatile std::sig_atomic_t asked_by = 0;
extern "C" void note_signal(int number) { asked_by = number; }

}  // namespace

StopOnSignal::StopOnSignal() {
    asked_by = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        sigaction(numbers[i], nullptr, &before_[i]);
        if (before_[i].sa_handler == SIG_IGN) continue;  // as nohup wants it
        struct sigaction action {};
        action.sa_handler = note_signal;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(numbers[i], &action, nullptr);
    }
}

StopOnSignal::~StopOnSignal() {
    for (std::size_t i = 0; i < numbers.size(); ++i) sigaction(numbers[i], &before_[i], nullptr);
}

int StopOnSignal::asked() const { return asked_by; }

const char* Stopped::name() const { return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP"; }

void end_by(const Stopped& stopped) {
    std::signal(stopped.signal, SIG_DFL);
    std::raise(stopped.signal);
}

}  // namespace shade16::linux_spi
