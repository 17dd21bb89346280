// What a reader promises of any bytes: it reads them, or throws host::Error with a sentence that names the file. Whatever else it
// throws ends the fuzzer, as does a sanitizer.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "host_sim/error.hpp"

namespace shade16::fuzz {

[[noreturn]] inline void break_contract(const std::string& complaint) {
    std::fprintf(stderr, "%s\n", complaint.c_str());
    std::abort();
}

inline std::string_view as_text(const uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

/// host::Error itself keeps it to one line that a terminal can show.
inline bool is_sentence(const std::string& text) { return text.size() > 10 && (text.ends_with('.') || text.ends_with('?')); }

/// Whether `read` came to an end without a refusal.
template <class Read>
bool is_accepted(const std::string& file, Read read) {
    try {
        read();
        return true;
    } catch (const host::Error& refusal) {
        const std::string sentence = refusal.what();
        if (!is_sentence(sentence)) break_contract("This is no sentence: " + sentence);
        if (sentence.find(file) == sentence.npos) break_contract("This does not name " + file + ": " + sentence);
        return false;
    }
}

}  // namespace shade16::fuzz
