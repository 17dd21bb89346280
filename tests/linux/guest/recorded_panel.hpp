// A panel on lines of the kernel module wire_recorder: the kernel's spi-gpio sends on some, libgpiod sets the others, and the display reads
// from the record what all of them did.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "boards/linux_spi/linux_bus.hpp"
#include "boards/linux_spi/spidev.hpp"
#include "host_sim/error.hpp"
#include "tests/linux/guest/kernel/wire_record.h"
#include "tests/linux/guest/light_log.hpp"
#include "tests/linux/guest/picture.hpp"
#include "tests/linux/wire_reader.hpp"

namespace shade16::linux_spi {

/// Every change of the lines since it was opened, each once.
class WireRecord {
public:
    WireRecord() : file_(open(path, O_RDONLY | O_CLOEXEC)) {
        if (file_ < 0) throw host::io_error("{} cannot be opened: {}; expected the module wire_recorder.", path, std::strerror(errno));
    }
    ~WireRecord() { close(file_); }
    WireRecord(const WireRecord&) = delete;
    WireRecord& operator=(const WireRecord&) = delete;

    /// Gives `look` what it has not given yet.
    template <class Look>
    void take(Look look) {
        std::array<wire_change, 4096> changes;
        for (;;) {
            const ssize_t bytes = read(file_, changes.data(), sizeof(changes));
            if (bytes < 0) throw host::io_error("{} cannot be read: {}; expected that before it is full.", path, std::strerror(errno));
            if (bytes == 0) return;
            std::for_each_n(changes.begin(), static_cast<size_t>(bytes) / sizeof(wire_change), look);
        }
    }

private:
    static constexpr const char* path = "/dev/wire_recorder";
    int file_;
};

/// Reads the wires as they were; what the program meant to send it does not know.
class RecordedPanel {
public:
    RecordedPanel() {
        record_.take([&](const wire_change& now) { before_ = now; });  // what is there at the beginning is no change
    }
    RecordedPanel(const RecordedPanel&) = delete;
    RecordedPanel& operator=(const RecordedPanel&) = delete;

    /// Looks at all that happened until now.
    void catch_up() {
        record_.take([&](const wire_change& now) { look_at(now); });
    }

    displays::DcsModel& model() { return model_; }
    bool in_a_byte() const { return reader_.in_a_byte(); }
    long bits() const { return bits_; }
    const std::string& lights() {
        catch_up();
        return light_.text();
    }
    /// The most bytes that came while the display was selected without a pause: those of a message.
    long most_bytes_at_once() const { return most_bits_at_once_ / 8; }
    /// Where the clock was when the display was last selected or left: what tells SPI's modes 0 and 3 apart.
    bool clock_rests_high() const { return clock_rests_high_; }
    /// Whether the display was ever selected or left in the middle of a byte, or its data/command line changed there.
    bool was_interrupted() const { return was_interrupted_; }

private:
    void look_at(const wire_change& now) {
        const uint32_t turned = now.levels ^ before_.levels;
        const auto high = [&](wire which) { return (now.levels >> which & 1) != 0; };
        const auto changed = [&](wire which) { return (turned >> which & 1) != 0; };
        before_ = now;
        if ((changed(wire_select) || changed(wire_command)) && reader_.in_a_byte()) was_interrupted_ = true;
        if (changed(wire_reset)) reader_.reset(high(wire_reset));
        if (changed(wire_light)) light_.look(high(wire_light));
        if (changed(wire_select)) bits_at_once_ = 0, clock_rests_high_ = high(wire_clock);
        if (changed(wire_clock) && high(wire_clock) && !high(wire_select)) look_at_bit(high(wire_command), high(wire_data));
    }
    void look_at_bit(bool is_data, bool bit) {
        reader_.clock_rises(is_data, bit);
        ++bits_;
        most_bits_at_once_ = std::max(most_bits_at_once_, ++bits_at_once_);
    }

    WireRecord record_{};
    displays::DcsModel model_{guest_panel};
    WireReader reader_{model_, [this] { return before_.at_us / 1000; }};
    LightLog light_{};
    wire_change before_{};
    bool was_interrupted_ = false, clock_rests_high_ = false;
    long bits_ = 0, bits_at_once_ = 0, most_bits_at_once_ = 0;
};

/// What drives it: the board's own parts as they are. The record is read between bands, because it holds two frames and no more.
class PanelOnSpidev {
public:
    using Bus = LinuxBus<>;
    struct WatchedDisplay {
        using Pixel = Bus::Format;
        RecordedPanel& seen;
        DcsDisplay<Bus, guest_panel, guest_orientation> display;
        void flush(Area area, const Pixel::Pixel* pixels, size_t bytes, bool last) {
            display.flush(area, pixels, bytes, last);
            seen.catch_up();
        }
        void wait() {}
    };

    PanelOnSpidev(RecordedPanel& seen, SystemCalls& system, const SpidevSettings& settings)
        : spi_(system, settings),
          lines_(OutputLine("panel-command"), OutputLine("panel-reset", {.initially = true}), OutputLine("panel-light")),
          display_{seen, DcsDisplay<Bus, guest_panel, guest_orientation>(Bus(spi_, lines_))} {
        spi_.set_row_bytes(guest_screen.width * sizeof(uint16_t));
        spi_.run_at_full_speed();
    }
    PanelOnSpidev(const PanelOnSpidev&) = delete;
    PanelOnSpidev& operator=(const PanelOnSpidev&) = delete;
    WatchedDisplay& display() { return display_; }

private:
    Spidev spi_;
    PanelLines<> lines_;
    WatchedDisplay display_;
};

}  // namespace shade16::linux_spi
