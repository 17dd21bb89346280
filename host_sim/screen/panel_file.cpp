#include "host_sim/screen/panel_file.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "host_sim/screen/panel_lines.hpp"
#include "host_sim/error.hpp"
#include "host_sim/model/text_lines.hpp"

namespace shade16::host {

namespace {

constexpr uint8_t no_operation = 0x00;

struct Command {
    uint8_t code;
    std::vector<uint8_t> parameters;
    std::size_t wait_ms;
};

/// Two numbers, and the line that has them.
struct Pair {
    int x = 0, y = 0;
    std::string where{};
};

/// The facts so far. What comes later holds, as it does for a controller.
class Reader {
public:
    Reader(std::string path, const ReadText& read) : path_(std::move(path)), read_(read) {}

    void take(std::string_view text) {
        const std::vector<PanelLine> lines = panel_lines(text, path_);
        for (const PanelLine& line : lines) {
            if (line.word == "as" && &line == &lines.front()) {
                take_other(line);
            } else {
                take(line);
            }
        }
    }
    PanelFile panel() const;

private:
    std::string beside(const std::string& name) const { return (std::filesystem::path(path_).parent_path() / (name + ".txt")).string(); }
    void take_other(const PanelLine& line) {
        const std::string other = beside(line.name);
        for (const PanelLine& others : panel_lines(text_beside(other, line), other)) {
            if (others.word == "as")
                throw input_error("{}: stands on another panel, and {} stands on this one; expected '#: as {}' there.", others.where,
                                  line.where, others.name);
            take(others);
        }
    }
    std::string text_beside(const std::string& path, const PanelLine& line) const {
        try {
            return read_(path);
        } catch (const Error& error) {
            throw input_error("{}: stands on '{}', which is looked for in the same folder: {}", line.where, line.name, error.what());
        }
    }
    void take(const PanelLine& line);
    void take_command(const PanelLine& line);
    void take_access(const PanelLine& line, uint8_t access);
    void wait(int ms) {
        if (list_.empty()) list_.push_back({no_operation, {}, 0});
        list_.back().wait_ms += static_cast<std::size_t>(ms);
    }
    void check() const;
    std::vector<uint8_t> beginning() const;

    std::string path_;
    const ReadText& read_;
    std::vector<Command> list_{};
    std::optional<Pair> glass_{}, memory_{};
    Pair offset_{};
    std::optional<uint8_t> access_{};
    bool inverted_ = false, wakes_ = false;
};

void Reader::take(const PanelLine& line) {
    const auto pair = [&line] { return Pair{line.numbers[0], line.numbers[1], line.where}; };
    if (line.word == "command") take_command(line);
    if (line.word == "delay") wait(line.numbers[0]);
    if (line.word == "glass") glass_ = pair();
    if (line.word == "memory") memory_ = pair();
    if (line.word == "offset") offset_ = pair();
    if (line.word == "as") throw input_error("{}: 'as' comes after other lines; expected it before them, once.", line.where);
}

/// What a driver sends by itself after the beginning, with its own orientation, is kept as facts; the rest is the beginning.
void Reader::take_command(const PanelLine& line) {
    const auto code = static_cast<uint8_t>(line.numbers[0]);
    const std::vector<uint8_t> parameters(line.numbers.begin() + 1, line.numbers.end());
    const auto takes = [&](std::size_t count) {
        if (parameters.size() != count)
            throw input_error("{}: command 0x{:02X} has {} parameters; expected {}.", line.where, code, parameters.size(), count);
    };
    switch (code) {
        case no_operation:  // with one parameter it is how the kernel's driver stores a delay
            if (parameters.size() == 1) return wait(parameters[0]);
            break;
        case dcs::memory_access: return takes(1), take_access(line, parameters[0]);
        case dcs::pixel_format:
            takes(1);
            if (parameters[0] != dcs::sixteen_bits && parameters[0] != 0x05)
                throw input_error("{}: the pixel format is 0x{:02X}; expected 0x55 or 0x05, 16 bits a pixel.", line.where, parameters[0]);
            return;
        case dcs::inverted:
        case dcs::not_inverted: takes(0), inverted_ = code == dcs::inverted; return;
        case dcs::normal_mode:
        case dcs::display_on: return takes(0);
        case dcs::sleep_out: takes(0), wakes_ = true; break;
        default: break;
    }
    list_.push_back({code, parameters, 0});
}

void Reader::take_access(const PanelLine& line, uint8_t access) {
    if ((access & dcs::exchanged) != 0)  // of a picture turned by a quarter, either way
        throw input_error("{}: command 0x36 0x{:02X} turns the picture; expected what an upright one takes, 0x{:02X} or 0x{:02X}.",
                          line.where, access, access ^ (dcs::exchanged | dcs::columns_mirrored), access ^ (dcs::exchanged | dcs::rows_mirrored));
    const int others = access & ~(dcs::rows_mirrored | dcs::columns_mirrored | dcs::blue_first);
    if (others != 0)
        throw input_error("{}: command 0x36 0x{:02X} sets the bits 0x{:02X}, which no driver here does; expected 0x80, 0x40 and 0x08 at most.",
                          line.where, access, others);
    access_ = access;
}

void Reader::check() const {
    if (!glass_) throw input_error("{}: does not say how large the glass is; expected a line such as '#: glass 240 320'.", path_);
    if (!access_) throw input_error("{}: does not say how the glass is wired; expected a line such as 'command 0x36 0x00'.", path_);
    if (!wakes_) throw input_error("{}: never wakes the panel; expected 'command 0x11' and 'delay 120'.", path_);
    if (glass_->x == 0 || glass_->y == 0) throw input_error("{}: the glass has no pixel; expected at least 1 by 1.", glass_->where);
    const Pair& memory = memory_ ? *memory_ : *glass_;
    if (offset_.x + glass_->x > memory.x || offset_.y + glass_->y > memory.y)
        throw input_error("{}: the glass of {}x{} at {}, {} is larger than the memory of {}x{}; expected '#: memory' of at least {} {}.",
                          glass_->where, glass_->x, glass_->y, offset_.x, offset_.y, memory.x, memory.y, offset_.x + glass_->x, offset_.y + glass_->y);
}

std::vector<uint8_t> Reader::beginning() const {
    constexpr std::size_t step_ms = 5, most_steps = 255;
    std::vector<uint8_t> bytes;
    for (const Command& command : list_) {
        std::size_t steps = (command.wait_ms + step_ms - 1) / step_ms;
        bytes.push_back(command.code);
        bytes.push_back(static_cast<uint8_t>(command.parameters.size() | (steps != 0 ? then_wait : 0u)));
        bytes.insert(bytes.end(), command.parameters.begin(), command.parameters.end());
        for (bool first = true; steps != 0; first = false) {
            const std::size_t now = std::min(steps, most_steps);
            if (!first) bytes.push_back(no_operation), bytes.push_back(then_wait);
            bytes.push_back(static_cast<uint8_t>(now));
            steps -= now;
        }
    }
    return bytes;
}

PanelFile Reader::panel() const {
    check();
    const Pair& memory = memory_ ? *memory_ : *glass_;
    PanelFile file{std::filesystem::path(path_).stem().string(), beginning(), {}};
    DcsPanel& facts = file.facts;
    facts.width_px = glass_->x, facts.height_px = glass_->y;
    facts.memory_width_px = memory.x, facts.memory_height_px = memory.y;
    facts.columns_mirrored = (*access_ & dcs::columns_mirrored) != 0;
    facts.rows_mirrored = (*access_ & dcs::rows_mirrored) != 0;
    facts.blue_first = (*access_ & dcs::blue_first) != 0;
    facts.inverted = inverted_;
    // The file has the offset of the upright picture; a DcsPanel, that from the end where memory begins.
    facts.first_column = facts.columns_mirrored ? memory.x - glass_->x - offset_.x : offset_.x;
    facts.first_row = facts.rows_mirrored ? memory.y - glass_->y - offset_.y : offset_.y;
    return file;
}

}  // namespace

DcsPanel PanelFile::panel() const {
    DcsPanel view = facts;
    view.name = name.c_str();
    view.beginning = beginning.data(), view.beginning_bytes = beginning.size();
    return view;
}

PanelFile read_panel_text(std::string_view text, const std::string& path, const ReadText& read) {
    Reader reader(path, read);
    reader.take(text);
    return reader.panel();
}

PanelFile read_panel_file(const std::string& path) { return read_panel_text(read_text(path), path, read_text); }

}  // namespace shade16::host
