#include "host_sim/cli/open_screen.hpp"

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/terminal_screen.hpp"
#include "host_sim/screen/framebuffer.hpp"
#include "host_sim/screen/panel_screen.hpp"
#include "host_sim/screen/printed_bus.hpp"
#ifdef SHADE16_HAS_GPIO
#include "host_sim/screen/wired_screen.hpp"
#endif

namespace shade16::host {

namespace {

#ifndef SHADE16_HAS_GPIO
std::unique_ptr<Screen> wired_screen(const Wires&, const Panel&, Orientation) {
    throw input_error("--board linux_spi: this program was built without libgpiod; expected it to be built where libgpiod-dev is installed.");
}
#endif

std::unique_ptr<Screen> panel_screen(const ScreenOptions& o) {
    const Panel panel = panel_by_name(o.panel);
    const Orientation orientation{o.quarter_turns, o.mirrored};
    if (o.dry_run) return std::make_unique<PanelScreen<PrintedBus>>(PrintedBus([](const std::string& text) { print(text); }), panel, orientation);
    expect_command_line(o.wires);
    return wired_screen(o.wires, panel, orientation);
}

}  // namespace

void expect_command_line(const Wires& wires) {
    if (wires.command.empty()) throw input_error("the data/command line is not said; expected a line such as --dc GPIO25.");
}

std::unique_ptr<Screen> open_screen(const ScreenOptions& o) {
    switch (o.kind) {
        case ScreenKind::fbdev: return std::make_unique<Framebuffer>(linux_spi::system_calls(), o.framebuffer, "/dev/tty0");
        case ScreenKind::terminal: return std::make_unique<TerminalScreen>();
        case ScreenKind::linux_spi: break;
    }
    return panel_screen(o);
}

}  // namespace shade16::host
