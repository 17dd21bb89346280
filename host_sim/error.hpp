// Error: what stops a command, as one sentence for its user and the exit code for the script that called it.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "host_sim/printable.hpp"

namespace shade16::host {

enum class ExitCode : int { ok = 0, check = 1, input = 2, io = 3 };

struct Error : std::runtime_error {
    Error(ExitCode exit_code, const std::string& sentence) : std::runtime_error(printable(sentence)), code(exit_code) {}
    ExitCode code;
};

/// The input or the command line is wrong: `throw input_error("{}: no faces", path)`.
template <class... Values>
Error input_error(fmt::format_string<Values...> sentence, Values&&... values) {
    return {ExitCode::input, fmt::format(sentence, std::forward<Values>(values)...)};
}

/// The input is fine, but the machine refused to read or to write.
template <class... Values>
Error io_error(fmt::format_string<Values...> sentence, Values&&... values) {
    return {ExitCode::io, fmt::format(sentence, std::forward<Values>(values)...)};
}

}  // namespace shade16::host
