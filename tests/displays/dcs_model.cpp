#include "tests/displays/dcs_model.hpp"

#include <array>
#include <cstdio>
#include <utility>

namespace shade16::displays {

namespace {

// ILI9341 data sheet, 8.2.2 (reset), 8.2.12 (sleep out); ST7789's and ST7735's are the same.
constexpr uint32_t after_reset_ms = 5, after_line_ms = 120, after_sleep_out_ms = 120;

std::string hex(unsigned byte) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "0x%02X", byte);
    return text.data();
}
std::string times(size_t n, const std::string& noun) { return std::to_string(n) + " " + noun + (n == 1 ? "" : "s"); }

/// How many parameters a command takes; -1 for those that only its maker knows.
int parameter_count(uint8_t command) {
    switch (command) {
        case dcs::reset:
        case dcs::sleep_out:
        case dcs::normal_mode:
        case dcs::not_inverted:
        case dcs::inverted:
        case dcs::display_off:
        case dcs::display_on: return 0;
        case dcs::columns:
        case dcs::rows: return 4;
        case dcs::memory_access:
        case dcs::pixel_format: return 1;
        default: return -1;
    }
}

}  // namespace

DcsModel::DcsModel(const DcsPanel& panel)
    : panel_(panel),
      memory_(static_cast<size_t>(panel.memory_width_px * panel.memory_height_px)),
      known_(memory_.size()) {}

void DcsModel::reset_line(bool high) {
    if (!high) {  // what had begun is forgotten, but for the memory
        has_command_ = false, parameters_.clear();
        asleep_ = true, on_ = false, inverted_ = false, access_ = 0, format_ = 0x66;
    }
    if (high && !line_high_) was_reset_ = true, may_command_ms_ = now_ms_ + after_line_ms, may_show_ms_ = may_command_ms_;
    line_high_ = high;
}

void DcsModel::command(uint8_t byte) {
    finish_command();
    command_ = byte, has_command_ = true;
    if (!line_high_) complain("command " + hex(byte) + " came while the reset line was low");
    if (!was_reset_) complain("command " + hex(byte) + " came before the display was reset");
    if (now_ms_ < may_command_ms_)
        complain("command " + hex(byte) + " came " + std::to_string(may_command_ms_ - now_ms_) + " ms too early after a reset or sleep out");
    switch (byte) {
        case dcs::reset: asleep_ = true, on_ = false, access_ = 0, format_ = 0x66, may_command_ms_ = now_ms_ + after_reset_ms; break;
        case dcs::sleep_out: asleep_ = false, may_command_ms_ = now_ms_ + after_sleep_out_ms; break;
        case dcs::not_inverted: inverted_ = false; break;
        case dcs::inverted: inverted_ = true; break;
        case dcs::display_off: on_ = false; break;
        case dcs::display_on:
            if (asleep_) complain("the display was switched on while it slept");
            on_ = true;
            break;
        case dcs::write_memory: column_ = columns_.first, row_ = rows_.first, written_ = 0; break;
        default: break;
    }
}

void DcsModel::data(uint8_t byte) {
    if (!has_command_) return complain("data " + hex(byte) + " came before any command");
    parameters_.push_back(byte);
    if (command_ == dcs::write_memory) {
        if (parameters_.size() < 2) return;
        take_pixel(static_cast<uint16_t>(parameters_[0] << 8 | parameters_[1]));
        parameters_.clear();
        return;
    }
    const int count = parameter_count(command_);
    if (count >= 0 && parameters_.size() > static_cast<size_t>(count))
        return complain("command " + hex(command_) + " takes " + times(static_cast<size_t>(count), "parameter") + ", and more came: was the data/command line low?");
    if (parameters_.size() != static_cast<size_t>(count)) return;
    const bool exchanged = has(dcs::exchanged);
    if (command_ == dcs::memory_access) access_ = byte;
    if (command_ == dcs::pixel_format) format_ = byte;
    if (command_ == dcs::columns) take_window(columns_, "columns", exchanged ? panel_.memory_height_px : panel_.memory_width_px);
    if (command_ == dcs::rows) take_window(rows_, "rows", exchanged ? panel_.memory_width_px : panel_.memory_height_px);
}

/// What a command still lacks when the next one comes.
void DcsModel::finish_command() {
    if (!has_command_) return;
    const int count = parameter_count(command_);
    if (command_ == dcs::write_memory) {
        const size_t window = static_cast<size_t>((columns_.last - columns_.first + 1) * (rows_.last - rows_.first + 1));
        if (!parameters_.empty()) complain("a pixel ended after its first byte");
        else if (written_ < window) complain("the window has " + times(window, "pixel") + ", and " + std::to_string(written_) + " came");
    } else if (count > 0 && parameters_.size() < static_cast<size_t>(count)) {
        complain("command " + hex(command_) + " takes " + times(static_cast<size_t>(count), "parameter") + ", and " + std::to_string(parameters_.size()) + " came");
    }
    parameters_.clear();
}

void DcsModel::take_window(Range& range, const char* what, int size) {
    range = {parameters_[0] << 8 | parameters_[1], parameters_[2] << 8 | parameters_[3]};
    if (range.first > range.last || range.last >= size)
        complain(std::string("the window has ") + what + " " + std::to_string(range.first) + " to " + std::to_string(range.last) + ", and the memory " + what + " 0 to " + std::to_string(size - 1));
}

void DcsModel::take_pixel(uint16_t pixel) {
    if ((format_ & 7) != 5) return complain("pixels of 16 bits came, and the pixel format is " + hex(format_));
    if (row_ > rows_.last) return complain("more pixels came than the window has");
    const bool exchanged = has(dcs::exchanged);
    int x = exchanged ? row_ : column_, y = exchanged ? column_ : row_;
    if (has(dcs::columns_mirrored)) x = panel_.memory_width_px - 1 - x;
    if (has(dcs::rows_mirrored)) y = panel_.memory_height_px - 1 - y;
    if (x >= 0 && y >= 0 && x < panel_.memory_width_px && y < panel_.memory_height_px) {
        const size_t at = static_cast<size_t>(y * panel_.memory_width_px + x);
        memory_[at] = pixel, known_[at] = true;
    }
    ++written_;
    if (++column_ > columns_.last) column_ = columns_.first, ++row_;
}

void DcsModel::end() {
    finish_command();
    if (!complaint_.empty()) return;
    if (asleep_) return complain("the display still sleeps");
    if (!on_) return complain("the display was never switched on");
    for (int y = 0; y < panel_.height_px; ++y)
        for (int x = 0; x < panel_.width_px; ++x)
            if (!known_[static_cast<size_t>((y + panel_.first_row) * panel_.memory_width_px + x + panel_.first_column)])
                return complain("column " + std::to_string(x) + " of row " + std::to_string(y) + " of the glass shows what was there before");
}

Seen DcsModel::seen() const {
    Seen seen{panel_.width_px, panel_.height_px, {}};
    seen.pixels.resize(static_cast<size_t>(seen.width * seen.height));
    for (int y = 0; y < seen.height; ++y)
        for (int x = 0; x < seen.width; ++x) {
            uint16_t p = memory_[static_cast<size_t>((y + panel_.first_row) * panel_.memory_width_px + x + panel_.first_column)];
            if (inverted_ != panel_.inverted) p = static_cast<uint16_t>(~p);
            if (has(dcs::blue_first) != panel_.blue_first) p = static_cast<uint16_t>(p << 11 | (p & 0x07E0) | p >> 11);
            seen.at(panel_.columns_mirrored ? seen.width - 1 - x : x, panel_.rows_mirrored ? seen.height - 1 - y : y) = p;
        }
    return seen;
}

}  // namespace shade16::displays
