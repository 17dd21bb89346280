// Colours, sizes and words.
#include <algorithm>

#include "host_sim/nearest_word.hpp"
#include "host_sim/scene_file/decimal.hpp"
#include "host_sim/scene_file/table_reader.hpp"

namespace shade16::host {

namespace {

constexpr Range shares{0, 1};
constexpr const char* a_color = R"([r, g, b], each from 0 to 1, or a text such as "#FF8855")";

/// "#FF8855"
std::optional<Rgb> hexadecimal(const std::string& text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    if (text.find_first_not_of("0123456789abcdefABCDEF", 1) != text.npos) return std::nullopt;
    return rgb(static_cast<uint32_t>(std::stoul(text.substr(1), nullptr, 16)));
}

std::string quoted(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
    return text;
}

}  // namespace

Rgb TableReader::color(const std::string& key, const TomlValue& value) const {
    if (const auto* text = std::get_if<std::string>(&value.value)) {
        const std::optional<Rgb> hex = hexadecimal(*text);
        if (!hex) throw wrong(key, fmt::format("is \"{}\"; expected {}", *text, a_color));
        return *hex;
    }
    const TomlArray& channels = list(key, value, 3, a_color);
    const auto channel = [&](std::size_t i) { return unorm_of(number(key, channels[i], shares, nullptr)); };
    return {channel(0), channel(1), channel(2)};
}

void TableReader::read(const std::string& key, Rgb& value) const {
    if (const TomlValue* const found = find(key)) value = color(key, *found);
}

void TableReader::read(const std::string& key, std::vector<Rgb>& value) const {
    const TomlValue* const found = find(key);
    if (found == nullptr) return;
    const auto* elements = std::get_if<TomlArray>(&found->value);
    if (elements == nullptr || elements->empty()) throw wrong_kind(key, *found, "a list of colours, one a vertex");
    value.clear();
    for (const TomlValue& element : *elements) value.push_back(color(key, element));
}

void TableReader::read(const std::string& key, Viewport& value) const {
    const TomlValue* const found = find(key);
    if (found == nullptr) return;
    const std::string expected = fmt::format("[width, height], whole numbers from 1 to {}", max_target_px);
    const TomlArray& elements = list(key, *found, 2, expected.c_str());
    std::array<int, 2> px{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto* whole = std::get_if<int64_t>(&elements[i].value);
        if (whole == nullptr || *whole < 1 || *whole > max_target_px)
            throw wrong(key, "is out of range; expected " + expected);
        px[i] = static_cast<int>(*whole);
    }
    value = {px[0], px[1]};
}

std::optional<std::size_t> TableReader::word(const std::string& key, const std::vector<std::string>& words) const {
    if (!has(key)) return std::nullopt;
    std::string typed;
    read(key, typed);
    const auto found = std::find(words.begin(), words.end(), typed);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    const std::string near = nearest_word(typed, words);
    throw wrong(key, fmt::format("is \"{}\"; expected {}{}", typed, quoted(words),
                                 near.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", near)));
}

}  // namespace shade16::host
