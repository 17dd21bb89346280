// Sentences about a command line that nobody understands.
#pragma once

#include <string>
#include <vector>

namespace shade16::host {

/// "--szie: there is no such option; did you mean --size?", or what `expected` says when no known word is near.
std::string unknown_word(const std::string& word, const char* kind, const std::vector<std::string>& known,
                         const std::string& expected);

/// "render, compare or bake"
std::string listed(const std::vector<std::string>& words);

/// Throws "--tier midiump: expected lowp, mediump or highp; did you mean mediump?" unless the word is known.
void expect_one_of(const char* option, const std::string& word, const std::vector<std::string>& known);

/// A complaint of CLI11's, by the name of its class and its text, in our words.
std::string reworded(const std::string& error_class, std::string text);

}  // namespace shade16::host
