// The lines of a panel's file: words, numbers, and the sentences for what is neither.
#pragma once

#include <stdint.h>

#include <string>
#include <string_view>
#include <vector>

namespace shade16::host {

/// What a line says: a word and its numbers, or its name in `as NAME`.
struct PanelLine {
    std::string where{};  // "file, line 3"
    std::string word{};
    std::vector<int> numbers{};
    std::string name{};
};

/// All lines that say something. Those of the kernel's tool are `command` and `delay`, with 0 to 255; ours, in comments that begin with
/// "#:", are `as`, `glass`, `memory` and `offset`. Throws input_error.
std::vector<PanelLine> panel_lines(std::string_view text, const std::string& path);

}  // namespace shade16::host
