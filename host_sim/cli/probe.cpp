#include <unistd.h>

#include <memory>
#include <utility>
#include <vector>

#include "boards/linux_spi/system_calls.hpp"
#include "host_sim/cli/ink.hpp"
#include "host_sim/cli/open_screen.hpp"
#include "host_sim/screen/panel_by_name.hpp"
#ifdef SHADE16_HAS_GPIO
#include "boards/linux_spi/output_line.hpp"
#endif

namespace shade16::host {

namespace {

/// Collects a line for each thing that is there or not.
class Findings {
public:
    /// `action` throws where `value` is missing.
    template <class Action>
    void look(const std::string& option, const std::string& value, Action action, const char* found = "ok") {
        try {
            action();
            text_ += fmt::format("{:<8} {} {}\n", found, option, value);
        } catch (const Error& error) {
            text_ += fmt::format("missing  {}: {}\n", option, error.what());
            is_ready_ = false;
        }
    }
    Probe probe() const { return {text_, is_ready_}; }

private:
    std::string text_{};
    bool is_ready_ = true;
};

/// Takes it, as two names may be those of one line. What is low when it acts stays high.
void look_for_line(Findings& findings, std::vector<std::shared_ptr<void>>& taken, const std::string& option, const std::string& line) {
    if (line.empty()) return;
    findings.look(option, line, [&] {
#ifdef SHADE16_HAS_GPIO
        taken.push_back(std::make_shared<linux_spi::OutputLine>(line, linux_spi::LineOptions{.initially = option == "--reset" || option == "--select"}));
#else
        throw input_error("this program was built without libgpiod; expected it to be built where libgpiod-dev is installed.");
#endif
    });
}

void look_for_wires(Findings& findings, const ScreenOptions& o) {
    const Wires& w = o.wires;
    findings.look("--panel", o.panel, [&] { panel_by_name(o.panel); }, "known");  // a panel says nothing of itself
    if (w.clock.empty()) findings.look("--spi", w.spi.device, [&] { linux_spi::Spidev spi(linux_spi::system_calls(), w.spi); });
    if (w.command.empty()) findings.look("--dc", "", [&] { expect_command_line(w); });
    std::vector<std::shared_ptr<void>> taken;
    for (const auto& [option, line] : {std::pair{"--dc", w.command}, {"--reset", w.reset}, {"--backlight", w.backlight}, {"--clock", w.clock},
                                       {"--data", w.data}, {"--select", w.select}})
        look_for_line(findings, taken, option, line);
}

}  // namespace

Probe probe(const ScreenOptions& o) {
    Findings findings;
    if (o.kind == ScreenKind::linux_spi) look_for_wires(findings, o);
    if (o.kind == ScreenKind::fbdev) findings.look("--framebuffer", o.framebuffer, [&] { open_screen(o); });
    if (o.kind == ScreenKind::terminal) findings.look("--board", "terminal", [] {
        if (!is_terminal(STDOUT_FILENO)) throw input_error("standard output is no terminal; expected one.");
    });
    return findings.probe();
}

}  // namespace shade16::host
