// The bus of a display on this computer: what sends bytes, and the lines beside it. A DisplayBus of firmware/display/dcs.hpp.
#pragma once

#include <optional>
#include <shade16/shade16.hpp>
#include <utility>

#include "boards/linux_spi/byte_sender.hpp"
#include "boards/linux_spi/output_line.hpp"
#include "boards/linux_spi/system_calls.hpp"

namespace shade16::linux_spi {

/// The lines of a display beside those of its SPI. A module may have its reset tied to the supply, or its backlight.
/// `Line` has set(bool): `reset` is low while the display is reset, `backlight` on while it shines.
template <class Line = OutputLine>
class PanelLines {
public:
    enum class AtEnd { dark, as_it_is };

    explicit PanelLines(Line command, std::optional<Line> reset = std::nullopt, std::optional<Line> backlight = std::nullopt, AtEnd at_end = AtEnd::dark)
        : command_(std::move(command)), reset_(std::move(reset)), backlight_(std::move(backlight)), at_end_(at_end) {}
    PanelLines(const PanelLines&) = delete;
    PanelLines& operator=(const PanelLines&) = delete;
    ~PanelLines() {
        if (at_end_ == AtEnd::dark) try {
                shine(false);
            } catch (...) {  // its chip is gone: whoever set a line last was told
            }
    }

    void command(bool is_command) { command_.set(!is_command); }
    void reset(bool is_reset) {
        if (reset_) reset_->set(!is_reset);
    }
    void shine(bool on) {
        if (backlight_) backlight_->set(on);
    }

private:
    Line command_;
    std::optional<Line> reset_, backlight_;
    AtEnd at_end_;
};

/// Refers to its sender and lines, so that a display may have a copy. `Spi` has send(bytes, count): a ByteSender.
template <class Spi = ByteSender, class Line = OutputLine>
class LinuxBus {
public:
    using Format = Rgb565Swapped;

    LinuxBus(Spi& spi, PanelLines<Line>& lines, SystemCalls& system = system_calls()) : spi_(&spi), lines_(&lines), system_(&system) {}

    void reset() {
        lines_->shine(false), shines_ = false;
        lines_->command(false), lines_->reset(false);
        lines_->reset(true), delay_ms(1), lines_->reset(false), delay_ms(120);
    }
    void command(uint8_t byte) {
        lines_->command(true), spi_->send(&byte, 1);
        lines_->command(false);
    }
    void data(const uint8_t* bytes, size_t count) { spi_->send(bytes, count); }
    void pixels(const Format::Pixel* pixels, size_t count) {
        spi_->send(reinterpret_cast<const uint8_t*>(pixels), count * sizeof(*pixels));
        if (!shines_) lines_->shine(true), shines_ = true;  // there is something to see
    }
    void wait() {}  // nothing is sent behind anybody's back
    void delay_ms(uint32_t ms) { system_->sleep_ms(ms); }

private:
    Spi* spi_;
    PanelLines<Line>* lines_;
    SystemCalls* system_;
    bool shines_ = false;
};

}  // namespace shade16::linux_spi
