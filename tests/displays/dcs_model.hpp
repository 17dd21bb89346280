// A strict display of the Display Command Set: it takes what a bus sends, says in a sentence what a real one would not forgive, and shows
// what a person in front of the glass sees.
#pragma once

#include <display/dcs.hpp>
#include <string>
#include <vector>

namespace shade16::displays {

/// A picture of RGB565 codes, as seen from the front.
struct Seen {
    int width = 0, height = 0;
    std::vector<uint16_t> pixels;
    uint16_t& at(int x, int y) { return pixels[static_cast<size_t>(y * width + x)]; }
    uint16_t at(int x, int y) const { return pixels[static_cast<size_t>(y * width + x)]; }
    friend bool operator==(const Seen&, const Seen&) = default;
};

class DcsModel {
public:
    explicit DcsModel(const DcsPanel& panel);

    void reset_line(bool high);
    void command(uint8_t byte);
    void data(uint8_t byte);
    void delay_ms(uint32_t ms) { now_ms_ += ms; }

    /// The first thing that was wrong, or nothing; `end` also looks at what is missing.
    const std::string& complaint() const { return complaint_; }
    void end();
    bool is_on() const { return on_; }
    Seen seen() const;

private:
    struct Range {
        int first = 0, last = 0;
    };

    void complain(const std::string& sentence) {
        if (complaint_.empty()) complaint_ = sentence;
    }
    void finish_command();
    void take_window(Range& range, const char* what, int size);
    void take_pixel(uint16_t pixel);
    bool has(uint8_t bit) const { return (access_ & bit) != 0; }

    const DcsPanel& panel_;
    std::string complaint_{};
    uint32_t now_ms_ = 0, may_command_ms_ = 0, may_show_ms_ = 0;
    bool line_high_ = true, was_reset_ = false, asleep_ = true, on_ = false, inverted_ = false, has_command_ = false;
    uint8_t command_ = 0, access_ = 0, format_ = 0x66;
    std::vector<uint8_t> parameters_{};
    Range columns_{}, rows_{};
    int column_ = 0, row_ = 0;
    size_t written_ = 0;
    std::vector<uint16_t> memory_;
    std::vector<bool> known_;
};

}  // namespace shade16::displays
