// What runs in the guest: the board's own code over the real libgpiod and the kernel's gpio-sim.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "boards/linux_spi/find_line.hpp"
#include "boards/linux_spi/stop_on_signal.hpp"
#include "tests/displays/turned.hpp"
#include "tests/linux/guest/simulated_panel.hpp"

namespace shade16::linux_spi {
namespace {

constexpr const char* usage =
    "usage: guest show CHIP | draw CHIP | try LINE | low CHIP | hold LINE CONSUMER | used | as UID COMMAND... | in_the_foreground COMMAND...\n"
    "CHIP is the simulator's folder of a chip, /sys/devices/platform/gpio-sim.0/gpiochip0.";

/// Which lines the kernel says are in use.
int used() {
    int count = 0;
    for (const std::string& path : chips_of("/dev")) {
        const gpio::Chip chip(path);
        for (unsigned offset = 0; offset < chip.line_count(); ++offset)
            if (const gpio::LineInfo line = chip.line(offset); line.used)
                std::printf("in use: %s of %s, by '%s'\n", line.name.c_str(), path.c_str(), line.consumer.c_str()), ++count;
    }
    std::printf("lines in use: %d\n", count);
    return 0;
}

/// Shows the torus once, and compares what the display has with what was drawn.
int show(const std::string& chip) {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<uint16_t> drawn = torus_codes();
    SimulatedPanel panel(chip);
    {
        DrivenPanel driven(panel);
        present_torus(driven.display());
    }
    panel.model().end();
    const displays::Seen seen = displays::turned(panel.model().seen(), {(4 - guest_orientation.quarter_turns) & 3});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::fprintf(stderr, "time: %.1f s for %ld bits\n", took.count(), panel.bits());
    std::printf("bits read: %ld, in a byte at the end: %d\n", panel.bits(), panel.in_a_byte());
    std::printf("complaint: %s\n", panel.model().complaint().empty() ? "none" : panel.model().complaint().c_str());
    std::printf("drawn %08X, seen %08X\n", static_cast<unsigned>(hash_of(drawn)), static_cast<unsigned>(hash_of(seen.pixels)));
    std::printf("backlight: %s\n", panel.lights().c_str());
    const bool equal = seen.pixels == drawn && seen.width == guest_screen.width && panel.model().complaint().empty();
    std::printf("%s\n", equal ? "equal, pixel by pixel" : "not equal");
    return equal ? 0 : 1;
}

/// A display that asks between bands whether to stop, and says when it is in the middle of a frame.
struct StoppedBetweenBands {
    using Pixel = DrivenPanel::Display::Pixel;
    DrivenPanel::Display& display;
    const StopOnSignal& stop;
    int bands = 0;
    void flush(Area area, const Pixel::Pixel* pixels, size_t bytes, bool last) {
        stop.throw_if_asked();
        display.flush(area, pixels, bytes, last);
        if (++bands == 2) std::puts("drawing"), std::fflush(stdout);
    }
    void wait() {}
};

/// Draws until it is stopped, by a signal or a failure.
int draw(const std::string& chip) {
    SimulatedPanel panel(chip);
    const StopOnSignal stop;
    try {
        DrivenPanel driven(panel, DrivenPanel::Read::light_alone);
        StoppedBetweenBands bands{driven.display(), stop};
        try {
            for (;; bands.bands = 0) present_torus(bands);
        } catch (const Stopped& stopped) {
            std::printf("%s in mid-frame: %s\n", stopped.name(), bands.bands > 0 && bands.bands < guest_bands ? "yes" : "no");
            throw;
        }
    } catch (...) {  // the lines are gone, and the program is not: it is not the kernel who gave them back
        std::printf("backlight: %s\n", panel.lights().c_str());
        used();
        throw;
    }
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
