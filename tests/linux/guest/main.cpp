// What runs in the guest: the board's own code over the real libgpiod and the kernel's gpio-sim, and over the kernel's spidev.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "tests/linux/guest/drawing.hpp"
#include "tests/linux/guest/framebuffer_hash.hpp"
#include "tests/linux/guest/on_spidev.hpp"
#include "tests/linux/guest/simulated_panel.hpp"
#include "tests/linux/guest/watched.hpp"

namespace shade16::linux_spi {
namespace {

constexpr const char* usage =
    "usage: guest show CHIP | draw CHIP | try LINE | low CHIP | hold LINE CONSUMER | used | as UID COMMAND... | in_the_foreground COMMAND...\n"
    "       guest show_on_spidev DEVICE HOW | draw_on_spidev DEVICE | try_spidev DEVICE MODE | watch PROGRAM... | become PROGRAM...\n"
    "       guest framebuffer_hash DEVICE BITS PIXELS\n"
    "CHIP is the simulator's folder of a chip, /sys/devices/platform/gpio-sim.0/gpiochip0. DEVICE is /dev/spidev0.0.\n"
    "HOW is mode_0, mode_3 or untold.";

int show(const std::string& chip) {
    SimulatedPanel panel(chip);
    return show_once(panel, [&] { return DrivenPanel(panel); });
}

int draw(const std::string& chip) {
    SimulatedPanel panel(chip);
    return draw_until_stopped(panel, [&] { return DrivenPanel(panel, DrivenPanel::Read::light_alone); });
}

int try_line(const std::string& wanted) {
    OutputLine(wanted).set(true);
    OutputLine(wanted).set(true);  // busy, had the first not been given back
    std::printf("line '%s' was set twice\n", wanted.c_str());
    return 0;
}

/// A line that is on when it is low, as the simulator sees it.
int low(const std::string& chip) {
    const SimulatedWire wire(chip, 6);
    OutputLine line("gpiochip0:6", {.active_low = true, .initially = true});
    std::printf("on at once: %d", wire.high());
    line.set(false), std::printf(", off: %d", wire.high());
    line.set(true), std::printf(", on: %d\n", wire.high());
    return 0;
}

int hold(const std::string& wanted, const std::string& consumer) {
    const OutputLine line(wanted, {.consumer = consumer});
    std::puts("holding"), std::fflush(stdout);
    std::this_thread::sleep_for(std::chrono::minutes(5));
    return 0;
}

int run(const std::vector<std::string>& words);

/// A shell without job control lets what it starts in the background ignore Ctrl-C.
int in_the_foreground(const std::vector<std::string>& words) {
    std::signal(SIGINT, SIG_DFL);
    return run({words.begin() + 1, words.end()});
}

int as_user(const std::vector<std::string>& words) {
    const auto id = static_cast<unsigned>(std::atoi(words[1].c_str()));
    if (setgid(id) != 0 || setuid(id) != 0) throw host::io_error("user {} cannot be taken on; expected to be root.", id);
    return run({words.begin() + 2, words.end()});
}

int run(const std::vector<std::string>& words) {
    const std::string command = words.empty() ? "" : words[0];
    if (command == "show" && words.size() == 2) return show(words[1]);
    if (command == "draw" && words.size() == 2) return draw(words[1]);
    if (command == "show_on_spidev" && words.size() == 3) return show_on_spidev(words[1], words[2]);
    if (command == "draw_on_spidev" && words.size() == 2) return draw_on_spidev(words[1]);
    if (command == "try_spidev" && words.size() == 3) return try_spidev(words[1], static_cast<unsigned>(std::atoi(words[2].c_str())));
    if (command == "watch" && words.size() > 1) return watch({words.begin() + 1, words.end()});
    if (command == "become" && words.size() > 1) return become({words.begin() + 1, words.end()});
    if (command == "framebuffer_hash" && words.size() == 4) return framebuffer_hash(words[1], std::atoi(words[2].c_str()), std::atoi(words[3].c_str()));
    if (command == "try" && words.size() == 2) return try_line(words[1]);
    if (command == "low" && words.size() == 2) return low(words[1]);
    if (command == "hold" && words.size() == 3) return hold(words[1], words[2]);
    if (command == "used" && words.size() == 1) return used();
    if (command == "in_the_foreground" && words.size() > 1) return in_the_foreground(words);
    if (command == "as" && words.size() > 2) return as_user(words);
    throw host::input_error("{}", usage);
}

}  // namespace
}  // namespace shade16::linux_spi

int main(int count, char** words) {
    using namespace shade16;
    try {
        return linux_spi::run({words + 1, words + count});
    } catch (const host::Error& error) {
        std::fflush(stdout);
        std::fprintf(stderr, "%s\n", error.what());
        return static_cast<int>(error.code);
    } catch (const linux_spi::Stopped& stopped) {
        std::fflush(stdout);
        std::fprintf(stderr, "Stopped by %s; the display is dark, and every line released.\n", stopped.name());
        linux_spi::end_by(stopped);
    }
    return 1;
}
