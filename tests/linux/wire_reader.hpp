// What a display reads from its wires: a bit when the clock rises, a byte after eight, a command while the data/command line is low.
#pragma once

#include <chrono>

#include "tests/displays/dcs_model.hpp"

namespace shade16::linux_spi {

/// The model's time is this computer's, so that pauses that are too short show.
class WireReader {
public:
    explicit WireReader(displays::DcsModel& model) : model_(model) {}

    void reset(bool high) {
        pass_time();
        bits_ = 0;
        model_.reset_line(high);
    }
    void clock_rises(bool is_data, bool bit) {
        byte_ = static_cast<uint8_t>(byte_ << 1 | (bit ? 1 : 0));
        if (++bits_ < 8) return;
        pass_time();
        if (is_data) model_.data(byte_);
        else model_.command(byte_);
        bits_ = 0;
    }
    /// Whether a byte had begun.
    bool in_a_byte() const { return bits_ != 0; }

private:
    void pass_time() {
        const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin_).count();
        model_.delay_ms(static_cast<uint32_t>(since) - passed_ms_);
        passed_ms_ = static_cast<uint32_t>(since);
    }
    displays::DcsModel& model_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    uint32_t passed_ms_ = 0;
    uint8_t byte_ = 0;
    int bits_ = 0;
};

}  // namespace shade16::linux_spi
