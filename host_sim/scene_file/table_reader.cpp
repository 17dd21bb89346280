#include "host_sim/scene_file/table_reader.hpp"

#include <algorithm>

#include "host_sim/nearest_word.hpp"
#include "host_sim/scene_file/decimal.hpp"

namespace shade16::host {

std::string Range::text() const {
    if (without_least && without_largest) return fmt::format("a number above {} and below {}", least, largest);
    if (without_least) return fmt::format("a number above {} and up to {}", least, largest);
    return fmt::format("a number from {} to {}", least, largest);
}

TableReader::TableReader(std::string file, std::string what, const TomlValue& table, std::vector<std::string> known)
    : file_(std::move(file)), what_(std::move(what)), table_(std::get_if<TomlTable>(&table.value)), line_(table.line) {
    if (table_ == nullptr || table.is_date)
        throw input_error("{}:{}: {} is {}; expected a table.", file_, line_, what_, kind_of(table));
    for (const TomlEntry& entry : *table_) {
        if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
        const std::string near = nearest_word(entry.key, known);
        if (!near.empty())
            throw input_error("{}:{}: unknown key '{}' in {}; did you mean '{}'?", file_, entry.line, entry.key, what_,
                              near);
        throw input_error("{}:{}: unknown key '{}' in {}; expected one of {}.", file_, entry.line, entry.key, what_,
                          fmt::join(known, ", "));
    }
}

const TomlValue* TableReader::find(const std::string& key) const {
    for (const TomlEntry& entry : *table_)
        if (entry.key == key) return &entry.value;
    return nullptr;
}

int TableReader::line_of(const std::string& key) const {
    for (const TomlEntry& entry : *table_)
        if (entry.key == key) return entry.line;
    return line_;
}

Error TableReader::wrong(const std::string& key, const std::string& complaint) const {
    return input_error("{}:{}: '{}' in {} {}.", file_, line_of(key), key, what_, complaint);
}

Error TableReader::missing(const std::string& key, const std::string& expected) const {
    return input_error("{}:{}: {} has no '{}'; expected {}.", file_, line_, what_, key, expected);
}

Error TableReader::wrong_kind(const std::string& key, const TomlValue& value, const std::string& expected) const {
    return wrong(key, fmt::format("is {}; expected {}", kind_of(value), expected));
}

double TableReader::number(const std::string& key, const TomlValue& value, Range range, const char* expected) const {
    double v = 0;
    if (const auto* whole = std::get_if<int64_t>(&value.value)) {
        v = static_cast<double>(*whole);
    } else if (const auto* decimals = std::get_if<double>(&value.value)) {
        v = *decimals;
    } else {
        throw wrong_kind(key, value, expected != nullptr ? expected : range.text());
    }
    if (!range.holds(v)) throw wrong(key, fmt::format("is {}; expected {}", v, range.text()));
    return v;
}

const TomlArray& TableReader::list(const std::string& key, const TomlValue& value, std::size_t count,
                                   const char* expected) const {
    const auto* array = std::get_if<TomlArray>(&value.value);
    if (array == nullptr) throw wrong_kind(key, value, expected);
    if (array->size() != count) throw wrong(key, fmt::format("has {} elements; expected {}", array->size(), expected));
    return *array;
}

void TableReader::read(const std::string& key, bool& value) const {
    const TomlValue* const found = find(key);
    if (found == nullptr) return;
    const bool* const truth = std::get_if<bool>(&found->value);
    if (truth == nullptr || found->is_date) throw wrong_kind(key, *found, "true or false");
    value = *truth;
}

void TableReader::read(const std::string& key, std::string& value) const {
    const TomlValue* const found = find(key);
    if (found == nullptr) return;
    const auto* text = std::get_if<std::string>(&found->value);
    if (text == nullptr) throw wrong_kind(key, *found, "a text");
    value = *text;
}

void TableReader::read(const std::string& key, int& value, int least, int largest) const {
    const TomlValue* const found = find(key);
    if (found == nullptr) return;
    const auto* whole = std::get_if<int64_t>(&found->value);
    const std::string expected = fmt::format("a whole number from {} to {}", least, largest);
    if (whole == nullptr) throw wrong_kind(key, *found, expected);
    if (*whole < least || *whole > largest) throw wrong(key, fmt::format("is {}; expected {}", *whole, expected));
    value = static_cast<int>(*whole);
}

void TableReader::read(const std::string& key, double& value, Range range) const {
    if (const TomlValue* const found = find(key)) value = number(key, *found, range, nullptr);
}

void TableReader::read(const std::string& key, Q16& value, Range range) const {
    if (const TomlValue* const found = find(key)) value = q16_of(number(key, *found, range, nullptr));
}

void TableReader::read(const std::string& key, Scaled& value, Range range) const {
    if (const TomlValue* const found = find(key)) value = scaled_of(number(key, *found, range, nullptr));
}

void TableReader::read(const std::string& key, std::array<double, 3>& value, Range range) const {
    const TomlValue* const found = find(key);
    if (found == nullptr) return;
    const TomlArray& elements = list(key, *found, 3, "three numbers such as [0, 1.5, -2]");
    for (std::size_t i = 0; i < 3; ++i) value[i] = number(key, elements[i], range, nullptr);
}

void TableReader::read(const std::string& key, Vec3& value, Range range) const {
    if (!has(key)) return;
    std::array<double, 3> v{};
    read(key, v, range);
    value = {q16_of(v[0]), q16_of(v[1]), q16_of(v[2])};
}

void TableReader::read_scale(const std::string& key, Vec3& value, Range range) const {
    const TomlValue* const found = find(key);
    if (found == nullptr) return;
    if (std::holds_alternative<TomlArray>(found->value)) return read(key, value, range);
    const Q16 k = q16_of(number(key, *found, range, "one number, or three such as [1, 2, 1]"));
    value = {k, k, k};
}

}  // namespace shade16::host
