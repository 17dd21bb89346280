#include "boards/linux_spi/open_screen.hpp"

#include "boards/linux_spi/framebuffer.hpp"
#include "boards/linux_spi/panel_screen.hpp"
#include "boards/linux_spi/printed_bus.hpp"
#include "boards/linux_spi/terminal_screen.hpp"

namespace shade16::host {

std::unique_ptr<Screen> open_screen(const ScreenOptions& o) {
    if (o.kind == ScreenKind::fbdev) return std::make_unique<Framebuffer>(system_calls(), o.framebuffer);
    if (o.kind == ScreenKind::terminal) return std::make_unique<TerminalScreen>();
    throw input_error("--board linux_spi: not yet.");
}
std::string panels_text() { return ""; }
Probe probe(const ScreenOptions&) { return {}; }

}  // namespace shade16::host
