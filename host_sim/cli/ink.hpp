// Ink: colour for a word or two, only where somebody can see it and does not mind.
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

#include <unistd.h>

namespace shade16::host {

/// A terminal that understands escape sequences.
inline bool is_terminal(int descriptor) {
    const char* const terminal = std::getenv("TERM");
    return isatty(descriptor) && terminal != nullptr && std::string_view(terminal) != "dumb";
}

/// See no-color.org: set, and not to nothing.
inline bool wants_no_color() {
    const char* const value = std::getenv("NO_COLOR");
    return value != nullptr && *value != '\0';
}

class Ink {
public:
    explicit Ink(int descriptor) : is_colored_(is_terminal(descriptor) && !wants_no_color()) {}

    std::string good(std::string_view word) const { return colored("32", word); }
    std::string caution(std::string_view word) const { return colored("33", word); }
    std::string bad(std::string_view word) const { return colored("1;31", word); }

private:
    std::string colored(const char* code, std::string_view word) const {
        if (!is_colored_) return std::string(word);
        return std::string("\033[") + code + "m" + std::string(word) + "\033[0m";
    }

    bool is_colored_;
};

}  // namespace shade16::host
