// The only file that includes toml++.
#include "host_sim/scene_file/toml_value.hpp"

#include <algorithm>

#include <toml++/toml.h>

#include "host_sim/error.hpp"
#include "host_sim/scene_file/toml_names.hpp"

namespace shade16::host {

namespace {

int line_of(const toml::source_region& source) { return static_cast<int>(source.begin.line); }

TomlValue converted(const toml::node& node);

TomlTable converted_table(const toml::table& table) {
    std::vector<TomlEntry> entries;
    for (const auto& [key, node] : table)
        entries.push_back({std::string(key.str()), converted(node), line_of(key.source())});
    // toml++ sorts by name; people and error messages go from top to bottom.
    std::stable_sort(entries.begin(), entries.end(),
                     [](const TomlEntry& a, const TomlEntry& b) { return a.line < b.line; });
    TomlTable result;
    for (TomlEntry& entry : entries) result.add(std::move(entry));
    return result;
}

TomlArray converted_array(const toml::array& array) {
    TomlArray values;
    for (const toml::node& node : array) values.push_back(converted(node));
    return values;
}

TomlValue converted(const toml::node& node) {
    TomlValue result{.line = line_of(node.source())};
    if (const auto* table = node.as_table()) {
        result.value = converted_table(*table);
    } else if (const auto* array = node.as_array()) {
        result.value = converted_array(*array);
    } else if (const auto* text = node.as_string()) {
        result.value = text->get();
    } else if (const auto* whole = node.as_integer()) {
        result.value = whole->get();
    } else if (const auto* number = node.as_floating_point()) {
        result.value = number->get();
    } else if (const auto* truth = node.as_boolean()) {
        result.value = truth->get();
    } else {
        result.is_date = true;
    }
    return result;
}

/// The parser's complaint in one line, without the full stop that we add.
std::string one_line(std::string_view text) {
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    while (line.ends_with('.') || line.ends_with(' ')) line.pop_back();
    return line;
}

struct KindName {
    std::string operator()(bool) const { return "true or false"; }
    std::string operator()(int64_t) const { return "a whole number"; }
    std::string operator()(double) const { return "a number with decimals"; }
    std::string operator()(const std::string&) const { return "a text"; }
    std::string operator()(const TomlArray&) const { return "a list"; }
    std::string operator()(const TomlTable&) const { return "a table"; }
};

}  // namespace

TomlTable::TomlTable() : entries_(std::make_unique<std::vector<TomlEntry>>()) {}
TomlTable::TomlTable(const TomlTable& other) : entries_(std::make_unique<std::vector<TomlEntry>>(*other.entries_)) {}
TomlTable::TomlTable(TomlTable&&) noexcept = default;
TomlTable& TomlTable::operator=(TomlTable other) noexcept {
    entries_.swap(other.entries_);
    return *this;
}
TomlTable::~TomlTable() = default;

const TomlEntry* TomlTable::begin() const { return entries_->data(); }
const TomlEntry* TomlTable::end() const { return entries_->data() + entries_->size(); }
void TomlTable::add(TomlEntry entry) { entries_->push_back(std::move(entry)); }

TomlValue parse_toml(std::string_view text, const std::string& name) {
    constexpr int most_parts = 8;  // a scene file needs three
    if (const int line = LongNames(text, most_parts).line(); line != 0)
        throw input_error("{}:{}: has a name of more than {} parts; expected one such as materials.wall.diffuse.", name, line, most_parts);
    try {
        return converted(toml::parse(text));
    } catch (const toml::parse_error& error) {
        throw input_error("{}:{}: is not valid TOML: {}.", name, line_of(error.source()),
                          one_line(error.description()));
    }
}

std::string kind_of(const TomlValue& value) { return value.is_date ? "a date" : std::visit(KindName{}, value.value); }

}  // namespace shade16::host
