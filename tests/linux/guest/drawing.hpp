// What is asked of any panel in the guest: a frame that is the one that was drawn, and frames until something ends them.
// A panel has model(), bits(), in_a_byte() and lights(); what drives it has display(), a sink.
#pragma once

#include <chrono>
#include <cstdio>
#include <type_traits>

#include "boards/linux_spi/stop_on_signal.hpp"
#include "tests/displays/turned.hpp"
#include "tests/linux/guest/picture.hpp"
#include "tests/linux/guest/used_lines.hpp"

namespace shade16::linux_spi {

/// How long a frame takes goes beside the transcript, because it is never the same.
template <class Panel>
void print_time(const Panel& panel, std::chrono::steady_clock::time_point begin) {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::fprintf(stderr, "time: %.1f s for %ld bits\n", took.count(), panel.bits());
}

/// Shows the torus once, and compares what the display has with what was drawn.
template <class Panel, class Drive>
int show_once(Panel& panel, Drive drive) {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<uint16_t> drawn = torus_codes();
    {
        auto driven = drive();
        present_torus(driven.display());
    }
    const std::string lights = panel.lights();
    panel.model().end();
    const displays::Seen seen = displays::turned(panel.model().seen(), {(4 - guest_orientation.quarter_turns) & 3});
    print_time(panel, begin);
    std::printf("bits read: %ld, in a byte at the end: %d\n", panel.bits(), panel.in_a_byte());
    std::printf("complaint: %s\n", panel.model().complaint().empty() ? "none" : panel.model().complaint().c_str());
    std::printf("drawn %08X, seen %08X\n", static_cast<unsigned>(hash_of(drawn)), static_cast<unsigned>(hash_of(seen.pixels)));
    std::printf("backlight: %s\n", lights.c_str());
    const bool equal = seen.pixels == drawn && seen.width == guest_screen.width && panel.model().complaint().empty();
    std::printf("%s\n", equal ? "equal, pixel by pixel" : "not equal");
    return equal ? 0 : 1;
}

/// A display that asks between bands whether to stop, and says when it is in the middle of a frame.
template <class Display>
struct StoppedBetweenBands {
    using Pixel = Rgb565Swapped;
    Display& display;
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
template <class Panel, class Drive>
int draw_until_stopped(Panel& panel, Drive drive) {
    const StopOnSignal stop;
    try {
        auto driven = drive();
        StoppedBetweenBands<std::remove_reference_t<decltype(driven.display())>> bands{driven.display(), stop};
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

}  // namespace shade16::linux_spi
