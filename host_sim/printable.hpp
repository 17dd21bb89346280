// printable: what a file says, as a message may repeat it. A name with a line feed or an escape sequence must neither break a
// sentence nor reach the terminal.
#pragma once

#include <algorithm>
#include <string>

namespace shade16::host {

/// Control characters become question marks.
inline std::string printable(std::string text) {
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
    std::replace_if(text.begin(), text.end(), is_control, '?');
    return text;
}

}  // namespace shade16::host
