// Screens by what the command line says of them.
#pragma once

#include <memory>
#include <string>

#include "host_sim/screen/screen.hpp"
#include "boards/linux_spi/spidev.hpp"

namespace shade16::host {

enum class ScreenKind { linux_spi, fbdev, terminal };

struct ScreenOptions {
    ScreenKind kind = ScreenKind::linux_spi;
    std::string panel = "ili9341";  // a name that panels_text has, or a file that ends with .txt
    int quarter_turns = 0;
    bool mirrored = false;
    std::string command_line{}, reset_line{}, backlight_line{};  // of libgpiod; the last two may be empty
    std::string clock_line{}, data_line{}, select_line{};        // bits sent line by line, without SPI
    linux_spi::SpidevSettings spi{};
    std::string framebuffer = "/dev/fb0";
    bool dry_run = false;     // print what would be sent
    bool off_at_end = false;  // the panel and its light

    bool takes_stdout() const { return dry_run || kind == ScreenKind::terminal; }
};

/// Throws input_error or io_error with what is missing and what brings it.
std::unique_ptr<Screen> open_screen(const ScreenOptions& options);

/// The panels by name, a line each.
std::string panels_text();

/// What there is of what a screen needs, and the command that brings what is missing.
struct Probe {
    std::string text{};
    bool is_ready = false;
};
Probe probe(const ScreenOptions& options);

}  // namespace shade16::host
