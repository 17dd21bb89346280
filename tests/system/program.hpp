// The program itself, run as its users run it.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include <sys/wait.h>

#include "tests/system/scratch_directory.hpp"

namespace shade16::host {

struct Ran {
    int exit_code = -1;
    std::string out{}, err{};
};

/// Runs a line of shell; `$shade16` is the program.
inline Ran run_shell(const std::string& line) {
    const ScratchDirectory errors;  // not the test's own, which then holds the program's files alone
    const std::string command = "shade16='" SHADE16_PROGRAM "'; { " + line + "\n} 2>'" + errors.path("err") + "'";
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return {};
    Ran ran;
    std::array<char, 65536> buffer{};
    for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) ran.out.append(buffer.data(), n);
    const int status = pclose(pipe);
    ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ran.err = errors.read("err");
    return ran;
}

inline Ran shade16_program(const std::string& arguments) { return run_shell("\"$shade16\" " + arguments); }

inline std::string teapot() { return (source_directory() / "assets/teapot.obj").string(); }

}  // namespace shade16::host
