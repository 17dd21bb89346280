#include "host_sim/screen/panel_lines.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "host_sim/error.hpp"
#include "host_sim/model/text_lines.hpp"
#include "host_sim/nearest_word.hpp"
#include "shade16/target/band.hpp"

namespace shade16::host {

namespace {

constexpr std::size_t most_shown = 40;  // of a word, in a sentence

std::string shown(std::string_view word) { return std::string(word.substr(0, most_shown)) + (word.size() > most_shown ? "..." : ""); }

/// Decimal, or hexadecimal with 0x. The kernel's tool reads no decimal number that begins with 0, so neither do we.
bool parse(std::string_view word, int& value) {
    const bool hex = word.starts_with("0x") || word.starts_with("0X");
    if (hex) word.remove_prefix(2);
    if (word.empty() || word.front() == '-' || (!hex && word.size() > 1 && word.front() == '0')) return false;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, hex ? 16 : 10);
    if (end != word.data() + word.size() || error == std::errc::invalid_argument) return false;
    if (error == std::errc::result_out_of_range) value = std::numeric_limits<int>::max();
    return true;
}

int number(const PanelLine& line, std::string_view word, int most) {
    int value = 0;
    if (!parse(word, value))
        throw input_error("{}: '{}' of '{}' is not a number; expected one such as 120 or 0x78.", line.where, shown(word), line.word);
    if (value > most) {
        const char* const advice = line.word == "delay" ? " Write a longer delay as several lines." : "";
        throw input_error("{}: '{}' of '{}' is out of range; expected 0 to {}.{}", line.where, shown(word), line.word, most, advice);
    }
    return value;
}

/// How many numbers a word takes, and how large. A command is one byte, its parameters are the others.
struct Form {
    std::string_view word;
    std::size_t least, most;
    int largest;
    std::string_view example;
};
constexpr std::size_t most_parameters = 127;  // what a list of commands can count
constexpr Form forms[] = {
    {"command", 1, 1 + most_parameters, 255, "command 0xB1 0x00 0x18"}, {"delay", 1, 1, 255, "delay 120"},
    {"glass", 2, 2, max_target_px, "#: glass 240 320"},                 {"memory", 2, 2, 65535, "#: memory 240 320"},
    {"offset", 2, 2, 65535, "#: offset 0 80"},
};

void take_numbers(PanelLine& line, const std::vector<std::string_view>& words, const Form& form) {
    const std::size_t count = words.size() - 1;
    if (count > form.most && line.word == "command")
        throw input_error("{}: a command has {} parameters; expected at most {}.", line.where, count - 1, most_parameters);
    if (count < form.least || count > form.most)
        throw input_error("{}: '{}' has {} numbers; expected {}, as in '{}'.", line.where, line.word, count, form.least, form.example);
    for (std::size_t i = 1; i < words.size(); ++i) line.numbers.push_back(number(line, words[i], form.largest));
}

void take_name(PanelLine& line, const std::vector<std::string_view>& words) {
    const auto is_plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    if (words.size() != 2 || !std::all_of(words[1].begin(), words[1].end(), is_plain))
        throw input_error("{}: 'as' takes the name of a panel in the same folder; expected one such as '#: as st7789'.", line.where);
    line.name = words[1];
}

PanelLine parsed(std::string where, const std::vector<std::string_view>& words, const std::vector<std::string>& known) {
    PanelLine line{std::move(where), std::string(words[0]), {}, {}};
    if (std::find(known.begin(), known.end(), line.word) == known.end()) {
        const std::string nearest = nearest_word(shown(line.word), known);
        throw input_error("{}: unknown word '{}'; {}.", line.where, shown(line.word),
                          nearest.empty() ? fmt::format("expected '{}'", fmt::join(known, "', '")) : fmt::format("expected '{}'", nearest));
    }
    if (line.word == "as") {
        take_name(line, words);
    } else {
        take_numbers(line, words, *std::find_if(std::begin(forms), std::end(forms), [&](const Form& f) { return f.word == line.word; }));
    }
    return line;
}

}  // namespace

std::vector<PanelLine> panel_lines(std::string_view text, const std::string& path) {
    static const std::vector<std::string> kernels{"command", "delay"}, ours{"as", "glass", "memory", "offset"};
    std::vector<PanelLine> lines;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));

        const std::size_t comment = std::min(line.find('#'), line.size());
        const auto take = [&](std::string_view part, const std::vector<std::string>& known) {
            const auto words = words_of(part);
            if (!words.empty()) lines.push_back(parsed(fmt::format("{}, line {}", path, number), words, known));
        };
        take(line.substr(0, comment), kernels);
        if (line.substr(comment).starts_with("#:")) take(line.substr(comment + 2), ours);
    }
    return lines;
}

}  // namespace shade16::host
