// Screens by what the command line says of them.
#pragma once

#include <memory>
#include <string>

#include "host_sim/screen/screen.hpp"
#include "host_sim/screen/wires.hpp"

namespace shade16::host {

enum class ScreenKind { linux_spi, fbdev, terminal };

struct ScreenOptions {
    ScreenKind kind = ScreenKind::linux_spi;
    std::string panel = "ili9341";  // as panel_by_name reads it
    int quarter_turns = 0;
    bool mirrored = false;
    Wires wires{};
    std::string framebuffer = "/dev/fb0";
    bool dry_run = false;  // print what would be sent

    bool takes_stdout() const { return dry_run || kind == ScreenKind::terminal; }
};

/// Throws input_error or io_error with what is missing and what brings it.
std::unique_ptr<Screen> open_screen(const ScreenOptions& options);

/// Throws input_error if nobody said where the data/command line is.
void expect_command_line(const Wires& wires);

/// What there is of what a screen needs, and the command that brings what is missing.
struct Probe {
    std::string text{};
    bool is_ready = false;
};
Probe probe(const ScreenOptions& options);

}  // namespace shade16::host
