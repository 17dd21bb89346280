// What a display reads from its wires: a bit when the clock rises, a byte after eight, a command while the data/command line is low.
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "tests/displays/dcs_model.hpp"

namespace shade16::linux_spi {

/// Milliseconds since now, by this computer's clock.
inline std::function<uint32_t()> stopwatch() {
    using namespace std::chrono;
    const auto begin = steady_clock::now();
    return [begin] { return static_cast<uint32_t>(duration_cast<milliseconds>(steady_clock::now() - begin).count()); };
}

/// The model's time is this computer's or the record's of what is read, so that pauses that are too short show.
class WireReader {
public:
    explicit WireReader(displays::DcsModel& model, std::function<uint32_t()> now_ms = stopwatch())
        : model_(model), now_ms_(std::move(now_ms)) {}

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
        const uint32_t now = now_ms_();
        model_.delay_ms(now - passed_ms_);
        passed_ms_ = now;
    }
    displays::DcsModel& model_;
    std::function<uint32_t()> now_ms_;
    uint32_t passed_ms_ = 0;
    uint8_t byte_ = 0;
    int bits_ = 0;
};

}  // namespace shade16::linux_spi
