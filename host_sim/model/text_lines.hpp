// Lines and words of a text file, whoever wrote it: LF, CR LF or CR; a backslash at the end continues the line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shade16::host {

struct TextLine {
    std::string text{};  // continuations joined, no blanks around it
    std::size_t number = 0;
};

/// The file's bytes as text. Throws input_error if it is missing, unreadable, a directory or no text.
std::string read_text(const std::string& path);

std::vector<TextLine> lines_of(std::string_view text);
std::vector<std::string_view> words_of(std::string_view line);

/// What follows the first word.
std::string_view after_first_word(std::string_view line);

}  // namespace shade16::host
