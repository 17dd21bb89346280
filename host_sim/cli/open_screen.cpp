#include "host_sim/cli/open_screen.hpp"

#include <display/all_panels.hpp>

#include <optional>
#include <vector>

#include "host_sim/cli/console.hpp"
#include "boards/linux_spi/system_calls.hpp"
#include "host_sim/nearest_word.hpp"
#include "host_sim/screen/framebuffer.hpp"
#include "host_sim/screen/panel_file.hpp"
#include "host_sim/screen/panel_screen.hpp"
#include "host_sim/screen/printed_bus.hpp"
#include "host_sim/cli/terminal_screen.hpp"
#ifdef SHADE16_HAS_GPIO
#include "boards/linux_spi/bit_banged_spi.hpp"
#include "boards/linux_spi/linux_bus.hpp"
#endif

namespace shade16::host {

namespace {

/// A panel that a screen can keep: of its file, or one that is always there.
struct KeptPanel {
    std::optional<PanelFile> file{};
    DcsPanel facts{};
};

std::unique_ptr<KeptPanel> panel_of(const std::string& name) {
    auto kept = std::make_unique<KeptPanel>();
    if (name.ends_with(".txt")) {
        kept->file = read_panel_file(name);
        kept->facts = kept->file->panel();
        return kept;
    }
    std::vector<std::string> known;
    for (const DcsPanel& panel : all_panels) known.emplace_back(panel.name);
    for (const DcsPanel& panel : all_panels)
        if (name == panel.name) return kept->facts = panel, std::move(kept);
    const std::string near = nearest_word(name, known);
    throw input_error("--panel {}: no panel has this name{}; expected one of --list-panels, or a file that ends with .txt.", name,
                      near.empty() ? "" : "; did you mean '" + near + "'?");
}

Orientation orientation_of(const ScreenOptions& o) { return {o.quarter_turns, o.mirrored}; }

/// A panel's screen and what it stands on, which is there before it and after it. `Stand` has a panel and a bus.
template <class Stand>
class StandingScreen final : private Stand, public PanelScreen<typename Stand::Bus> {
public:
    StandingScreen(Stand stand, Orientation o) : Stand(std::move(stand)), PanelScreen<typename Stand::Bus>(Stand::bus, Stand::panel->facts, o) {}
};

struct PrintedStand {
    using Bus = PrintedBus;
    std::unique_ptr<KeptPanel> panel;
    Bus bus;
};

#ifdef SHADE16_HAS_GPIO
using linux_spi::OutputLine;

struct WiredStand {
    using Bus = linux_spi::LinuxBus<>;
    std::unique_ptr<KeptPanel> panel;
    std::unique_ptr<linux_spi::PanelLines<>> lines;
    std::unique_ptr<linux_spi::ByteSender> sender;
    Bus bus{*sender, *lines};
};

std::optional<OutputLine> optional_line(const std::string& name, bool initially) {
    if (name.empty()) return std::nullopt;
    return std::optional<OutputLine>(std::in_place, name, linux_spi::LineOptions{.initially = initially});
}

std::unique_ptr<Screen> bit_banged(const ScreenOptions& o, std::unique_ptr<KeptPanel> panel, std::unique_ptr<linux_spi::PanelLines<>> lines) {
    auto sender = std::make_unique<linux_spi::BitBangedSpi<>>(OutputLine(o.clock_line), OutputLine(o.data_line), optional_line(o.select_line, true));
    return std::make_unique<StandingScreen<WiredStand>>(WiredStand{std::move(panel), std::move(lines), std::move(sender)}, orientation_of(o));
}

std::unique_ptr<Screen> on_spidev(const ScreenOptions& o, std::unique_ptr<KeptPanel> panel, std::unique_ptr<linux_spi::PanelLines<>> lines) {
    auto sender = std::make_unique<linux_spi::Spidev>(linux_spi::system_calls(), o.spi);
    linux_spi::Spidev& spi = *sender;
    auto screen = std::make_unique<StandingScreen<WiredStand>>(WiredStand{std::move(panel), std::move(lines), std::move(sender)}, orientation_of(o));
    spi.set_row_bytes(2 * static_cast<std::size_t>(screen->size().width));
    spi.run_at_full_speed();
    return screen;
}

std::unique_ptr<Screen> wired(const ScreenOptions& o, std::unique_ptr<KeptPanel> panel) {
    using Lines = linux_spi::PanelLines<>;
    auto lines = std::make_unique<Lines>(OutputLine(o.command_line), optional_line(o.reset_line, true), optional_line(o.backlight_line, false),
                                         o.off_at_end ? Lines::AtEnd::dark : Lines::AtEnd::as_it_is);
    return o.clock_line.empty() ? on_spidev(o, std::move(panel), std::move(lines)) : bit_banged(o, std::move(panel), std::move(lines));
}
#else
std::unique_ptr<Screen> wired(const ScreenOptions&, std::unique_ptr<KeptPanel>) {
    throw input_error("--board linux_spi: this program was built without libgpiod; expected it to be installed before the build, which Debian has in libgpiod-dev.");
}
#endif

std::unique_ptr<Screen> linux_spi_screen(const ScreenOptions& o) {
    auto panel = panel_of(o.panel);
    if (o.dry_run) return std::make_unique<StandingScreen<PrintedStand>>(PrintedStand{std::move(panel), PrintedBus([](const std::string& text) { print(text); })}, orientation_of(o));
    if (o.command_line.empty()) throw input_error("--dc: the data/command line is missing; expected a line such as GPIO25.");
    if (o.clock_line.empty() != o.data_line.empty()) throw input_error("--clock and --data: one is missing; expected both, or neither and SPI.");
    return wired(o, std::move(panel));
}

}  // namespace

std::unique_ptr<Screen> open_screen(const ScreenOptions& o) {
    switch (o.kind) {
        case ScreenKind::fbdev: return std::make_unique<Framebuffer>(linux_spi::system_calls(), o.framebuffer);
        case ScreenKind::terminal: return std::make_unique<TerminalScreen>();
        case ScreenKind::linux_spi: break;
    }
    return linux_spi_screen(o);
}

std::string panels_text() {
    std::string text;
    for (const DcsPanel& panel : all_panels) text += fmt::format("{:<24}{}x{}\n", panel.name, panel.width_px, panel.height_px);
    return text;
}

}  // namespace shade16::host
