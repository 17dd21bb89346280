#include "host_sim/screen/wired_screen.hpp"

#include <optional>

#include "boards/linux_spi/bit_banged_spi.hpp"
#include "boards/linux_spi/linux_bus.hpp"
#include "host_sim/screen/panel_screen.hpp"

namespace shade16::host {

namespace {

using linux_spi::OutputLine;
using Lines = linux_spi::PanelLines<>;

OutputLine line(const Wires& wires, const std::string& name, bool initially = false) {
    return OutputLine(name, {.initially = initially, .devices = wires.devices});
}
std::optional<OutputLine> optional_line(const Wires& wires, const std::string& name, bool initially = false) {
    return name.empty() ? std::nullopt : std::optional(line(wires, name, initially));
}

/// The panel's screen, and what carries its bytes. The last to come is the first to go.
class WiredScreen final : public Screen {
public:
    WiredScreen(const Wires& wires, const Panel& panel, Orientation orientation, linux_spi::SystemCalls& system)
        : lines_(line(wires, wires.command), optional_line(wires, wires.reset, true), optional_line(wires, wires.backlight),
                 wires.is_dark_at_end ? Lines::AtEnd::dark : Lines::AtEnd::as_it_is),
          spidev_(wires.clock.empty() ? std::make_unique<linux_spi::Spidev>(system, wires.spi) : nullptr),
          bits_(wires.clock.empty() ? nullptr : bit_banged(wires)),
          panel_({spidev_ ? static_cast<linux_spi::ByteSender&>(*spidev_) : *bits_, lines_, system}, panel, orientation) {
        if (!spidev_) return;
        spidev_->set_row_bytes(2 * static_cast<std::size_t>(size().width));
        spidev_->run_at_full_speed();
    }

    Viewport size() const override { return panel_.size(); }
    const char* format() const override { return panel_.format(); }
    void switch_off() override { panel_.switch_off(); }
    std::size_t send(const Image& frame) override { return panel_.send(frame); }

private:
    static std::unique_ptr<linux_spi::ByteSender> bit_banged(const Wires& wires) {
        return std::make_unique<linux_spi::BitBangedSpi<>>(line(wires, wires.clock), line(wires, wires.data), optional_line(wires, wires.select, true));
    }

    Lines lines_;
    std::unique_ptr<linux_spi::Spidev> spidev_;
    std::unique_ptr<linux_spi::ByteSender> bits_;
    PanelScreen<linux_spi::LinuxBus<>> panel_;
};

}  // namespace

std::unique_ptr<Screen> wired_screen(const Wires& wires, const Panel& panel, Orientation orientation, linux_spi::SystemCalls& system) {
    return std::make_unique<WiredScreen>(wires, panel, orientation, system);
}

}  // namespace shade16::host
