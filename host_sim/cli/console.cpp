#include "host_sim/cli/console.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "host_sim/cli/ink.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/printable.hpp"

namespace shade16::host {

namespace {

/// Standard error may be closed, and then nobody listens: no reason to stop.
void print_error(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

void print(std::string_view text) { DirectStream("-").write(text); }

void print_beside(const std::string& output, std::string_view text) {
    if (is_standard_output(output)) return print_error(text);
    print(text);
}

void print_warnings(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) print_error(fmt::format("{} {}\n", Ink(STDERR_FILENO).caution("warning:"), printable(sentence)));
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

Progress::Progress(std::string_view verb, int total, bool quiet)
    : verb_(verb), total_(total), is_shown_(!quiet && total > 1 && is_terminal(STDERR_FILENO)) {}

Progress::~Progress() {
    if (is_written_) print_error("\r\033[K");
}

void Progress::begin(int index) {
    constexpr std::chrono::milliseconds a_while{500};
    if (!is_shown_ || std::chrono::steady_clock::now() - start_ < a_while) return;
    print_error(fmt::format("\r\033[K{} {} of {}", verb_, index + 1, total_));
    is_written_ = true;
}

}  // namespace shade16::host
