#include "host_sim/model/text_lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "host_sim/error.hpp"

namespace shade16::host {

namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace

std::string read_text(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw input_error("{}: is a directory; expected a text file.", path);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) throw input_error("{}: cannot be opened: {}.", path, std::strerror(errno));
    std::ostringstream text;
    // Inserting an empty file sets failbit on `text`; only `file` tells of a failed read.
    if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
    if (file.bad() || text.bad()) throw io_error("{}: cannot be read to its end.", path);

    std::string bytes = std::move(text).str();
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
    if (bytes.find('\0') != std::string::npos)
        throw input_error(
            "{}: is not a text file in ASCII or UTF-8; expected one (UTF-16 files can be saved as UTF-8).", path);
    return bytes;
}

std::vector<TextLine> lines_of(std::string_view text) {
    std::vector<TextLine> lines;
    bool continues = false;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));

        const bool goes_on = line.ends_with('\\') && !line.starts_with('#');
        if (goes_on) line.remove_suffix(1);
        if (continues) {
            lines.back().text.append(" ").append(line);
        } else {
            lines.push_back({std::string(line), number});
        }
        continues = goes_on;
    }
    return lines;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t end = std::min(line.find_first_of(blanks), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

std::string_view after_first_word(std::string_view line) {
    line = trimmed(line);
    return trimmed(line.substr(std::min(line.find_first_of(blanks), line.size())));
}

}  // namespace shade16::host
