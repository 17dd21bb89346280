// TomlValue: what a TOML file says, with the line of every key and value. The parser behind it stays in one .cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace shade16::host {

struct TomlValue;
struct TomlEntry;
using TomlArray = std::vector<TomlValue>;

/// In the order of the file. A class with everything out of line, because an entry holds a value and a value a table.
class TomlTable {
public:
    TomlTable();
    TomlTable(const TomlTable&);
    TomlTable(TomlTable&&) noexcept;
    TomlTable& operator=(TomlTable) noexcept;
    ~TomlTable();

    const TomlEntry* begin() const;
    const TomlEntry* end() const;
    void add(TomlEntry entry);

private:
    std::unique_ptr<std::vector<TomlEntry>> entries_;
};

struct TomlValue {
    std::variant<bool, int64_t, double, std::string, TomlArray, TomlTable> value{};
    bool is_date = false;  // a date or a time: valid TOML, but of no use to a scene
    int line = 0;
};

struct TomlEntry {
    std::string key{};
    TomlValue value{};
    int line = 0;  // of the key
};

/// `name` is what messages call the text. Throws input_error with the line: "scene.toml:3: ...".
TomlValue parse_toml(std::string_view text, const std::string& name);

/// "a number", "a table": for messages.
std::string kind_of(const TomlValue& value);

}  // namespace shade16::host
