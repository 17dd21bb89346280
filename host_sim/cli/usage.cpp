#include "host_sim/cli/usage.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "host_sim/error.hpp"
#include "host_sim/nearest_word.hpp"

namespace shade16::host {

std::string unknown_word(const std::string& word, const char* kind, const std::vector<std::string>& known,
                         const std::string& expected) {
    const std::string near = nearest_word(word, known);
    if (near == word) return fmt::format("{}: belongs after the command, as in 'shade16 render {}'.", word, word);
    if (near.empty()) return fmt::format("{}: there is no such {}; {}.", word, kind, expected);
    return fmt::format("{}: there is no such {}; did you mean {}?", word, kind, near);
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return text;
}

void expect_one_of(const char* option, const std::string& word, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), word) != known.end()) return;
    const std::string near = nearest_word(word, known);
    throw input_error("{} {}: expected {}{}", option, word, listed(known),
                      near.empty() ? std::string(".") : fmt::format("; did you mean {}?", near));
}

std::string reworded(const std::string& error_class, std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::string option = text.substr(0, std::min(text.find_first_of(": "), text.size()));
    if (text.ends_with("disallowed flag override")) return fmt::format("--{}: takes no value", option);
    if (error_class == "ArgumentMismatch") return option + ": expected a value after it";
    if (error_class != "RequiredError") return text;
    if (option == "--output") return "the name of the output is missing: expected -o and a name";
    if (option == "SCENE") return "the name of the scene is missing: expected SCENE.toml or MODEL.obj";
    if (option == "SUBJECT") return "what the report is about is missing: expected bounds";
    return text;
}

}  // namespace shade16::host
