// What people read: results, warnings, progress. Never mixed with data on standard output.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace shade16::host {

/// On standard output. Throws ClosedPipe or io_error like any other output.
void print(std::string_view text);

/// What was done: on standard output, or on standard error when the data went to the former.
void print_beside(const std::string& output, std::string_view text);

/// On standard error, as `warning: ...`.
void print_warnings(const std::vector<std::string>& sentences);

/// "1 vertex", "2 vertices"
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// `drawing 57 of 90`, rewritten in place; shown on a terminal alone, and only of work that takes a while.
class Progress {
public:
    Progress(std::string_view verb, int total, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void begin(int index);

private:
    std::string verb_;
    int total_;
    bool is_shown_, is_written_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace shade16::host
