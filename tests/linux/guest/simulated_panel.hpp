// A panel on lines of gpio-sim: the program drives them through libgpiod, and the display reads them from the simulator's own files.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <functional>

#include "boards/linux_spi/bit_banged_spi.hpp"
#include "boards/linux_spi/linux_bus.hpp"
#include "host_sim/error.hpp"
#include "tests/linux/guest/light_log.hpp"
#include "tests/linux/guest/picture.hpp"
#include "tests/linux/wire_reader.hpp"

namespace shade16::linux_spi {

/// A line as gpio-sim has it.
class SimulatedWire {
public:
    SimulatedWire(const std::string& chip, int offset) : path_(chip + "/sim_gpio" + std::to_string(offset) + "/value"), file_(open(path_.c_str(), O_RDONLY)) {
        if (file_ < 0) throw host::io_error("{} cannot be opened; expected a line of gpio-sim.", path_);
    }
    ~SimulatedWire() { close(file_); }
    SimulatedWire(const SimulatedWire&) = delete;
    SimulatedWire& operator=(const SimulatedWire&) = delete;

    bool high() const {
        char value = '?';
        if (pread(file_, &value, 1, 0) != 1 || (value != '0' && value != '1')) throw host::io_error("{} cannot be read; expected 0 or 1.", path_);
        return value == '1';
    }

private:
    std::string path_;
    int file_;
};

/// A line whose every change somebody looks at.
struct WatchedLine {
    OutputLine line;
    std::function<void()> after_each_change;
    void set(bool on) { line.set(on), after_each_change(); }
};

/// Reads the wires when one of them may have changed; what the program meant to set it does not know.
class SimulatedPanel {
public:
    explicit SimulatedPanel(const std::string& chip)
        : clock_(chip, 0), data_(chip, 1), command_(chip, 2), reset_(chip, 3), backlight_(chip, 4), select_(chip, 5) {}

    void look_at_clock() {
        const bool high = clock_.high();
        if (high && !clock_was_high_ && !select_.high()) reader_.clock_rises(command_.high(), data_.high()), ++bits_;
        clock_was_high_ = high;
    }
    void look_at_reset() { reader_.reset(reset_.high()); }
    void look_at_backlight() { light_.look(backlight_.high()); }

    displays::DcsModel& model() { return model_; }
    bool in_a_byte() const { return reader_.in_a_byte(); }
    long bits() const { return bits_; }
    const std::string& lights() const { return light_.text(); }

private:
    SimulatedWire clock_, data_, command_, reset_, backlight_, select_;
    displays::DcsModel model_{guest_panel};
    WireReader reader_{model_};
    LightLog light_{};
    bool clock_was_high_ = false;
    long bits_ = 0;
};

/// What drives it: the board's own parts, over watched lines. Reading every bit takes three times as long as sending it.
class DrivenPanel {
public:
    enum class Read { every_bit, light_alone };

    explicit DrivenPanel(SimulatedPanel& seen, Read read = Read::every_bit)
        : spi_(watched("GPIO11", [&seen, read] { if (read == Read::every_bit) seen.look_at_clock(); }), watched("GPIO10", [] {}), watched("GPIO8", [] {}, true)),
          lines_(watched("25", [] {}), watched("GPIO27", [&seen] { seen.look_at_reset(); }, true), watched("gpiochip0:4", [&seen] { seen.look_at_backlight(); })),
          display_(Bus(spi_, lines_)) {}
    using Bus = LinuxBus<BitBangedSpi<WatchedLine>, WatchedLine>;
    using Display = DcsDisplay<Bus, guest_panel, guest_orientation>;
    Display& display() { return display_; }

private:
    static WatchedLine watched(const std::string& name, std::function<void()> look, bool initially = false) {
        return {OutputLine(name, {.initially = initially}), std::move(look)};
    }
    BitBangedSpi<WatchedLine> spi_;
    PanelLines<WatchedLine> lines_;
    Display display_;
};

}  // namespace shade16::linux_spi
