#include "host_sim/cli/usage.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

namespace shade16::host {

namespace {

/// Letters to insert, remove or replace.
std::size_t distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

/// The known word nearest to a mistyped one, or "" when none is near.
std::string nearest(std::string_view typed, const std::vector<std::string>& known) {
    std::string best;
    std::size_t least = std::max<std::size_t>(typed.size() / 3, 1) + 1;  // a third of the letters may be wrong
    for (const std::string& word : known)
        if (const std::size_t d = distance(typed, word); d < least) least = d, best = word;
    return best;
}

}  // namespace

std::string unknown_word(const std::string& word, const char* kind, const std::vector<std::string>& known,
                         const std::string& expected) {
    const std::string near = nearest(word, known);
    if (near == word) return fmt::format("{}: belongs after the command, as in 'shade16 render {}'.", word, word);
    if (near.empty()) return fmt::format("{}: there is no such {}; {}.", word, kind, expected);
    return fmt::format("{}: there is no such {}; did you mean {}?", word, kind, near);
}

std::string reworded(const std::string& error_class, std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::string option = text.substr(0, std::min(text.find_first_of(": "), text.size()));
    if (text.ends_with("disallowed flag override")) return fmt::format("--{}: takes no value", option);
    if (error_class == "ArgumentMismatch") return option + ": expected a value after it";
    if (error_class != "RequiredError") return text;
    if (option == "--output") return "the name of the output is missing: expected -o and a name";
    return "the name of the model is missing: expected " + option;
}

}  // namespace shade16::host
