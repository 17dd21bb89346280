// What a terminal sees, and what a file or a pipe sees instead. util-linux's `script` plays the terminal.
#include <csignal>

#include <gmock/gmock.h>

#include "tests/requirements.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The same command in a terminal of 40 x 12 characters.
Ran in_terminal(const std::string& arguments, const std::string& environment = "") {
    const std::string command = "stty cols 40 rows 12; " + environment + " $shade16 " + arguments;
    return run_shell("export shade16 TERM=xterm-256color; unset NO_COLOR; script -qefc '" + command +
                     "' /dev/null </dev/null");
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

constexpr const char *hide = "\033[?25l", *show = "\033[?25h", *half_block = "\u2580";

TEST(CliTerminal, verdicts_are_coloured_on_a_terminal_alone) {
    if (!has_program("script")) GTEST_SKIP() << "script is not installed.";
    const std::string compare = "compare --frames 1 --size 20x20 " + teapot();
    EXPECT_THAT(in_terminal(compare).out, HasSubstr("\033[32mkept\033[0m"));
    EXPECT_THAT(in_terminal(compare, "NO_COLOR=1").out, Not(HasSubstr("\033[32m")));
    EXPECT_THAT(in_terminal(compare, "TERM=dumb").out, Not(HasSubstr("\033")));
    EXPECT_THAT(shade16_program(compare).out, Not(HasSubstr("\033")));
    EXPECT_THAT(in_terminal("compare /no/such.obj").out, StartsWith("\033[1;31mshade16:\033[0m /no/such.obj"));
}

TEST(CliTerminal, progress_is_shown_on_a_terminal_alone) {
    if (!has_program("script")) GTEST_SKIP() << "script is not installed.";
    const std::string compare = "compare --frames 300 --tier lowp " + teapot();  // longer than the while that it waits
    EXPECT_THAT(in_terminal(compare).out, HasSubstr("comparing lowp, frame "));
    EXPECT_THAT(in_terminal(compare + " --quiet").out, Not(HasSubstr("comparing")));
    EXPECT_EQ(shade16_program(compare).err, "");
}

TEST(CliPreview, fills_the_terminal_and_gives_the_cursor_back) {
    if (!has_program("script")) GTEST_SKIP() << "script is not installed.";
    const std::string out = in_terminal("preview --frames 3 " + teapot()).out;
    EXPECT_EQ(count_of(out, half_block), 3u * 40 * 11);
    EXPECT_EQ(count_of(out, "\r\033[10A"), 2u);  // back to the top of the frame
    EXPECT_EQ(count_of(out, hide), 1u);
    EXPECT_GT(out.find(show), out.rfind(half_block));
}

TEST(CliPreview, ctrl_c_gives_the_cursor_back) {
    if (!has_program("script")) GTEST_SKIP() << "script is not installed.";
    // `timeout` makes a background job of what it runs where it is not the shell itself, as from dash.
    for (const char* shell : {"/bin/sh", "/bin/bash"})
        for (const char* place : {"", "--foreground "}) {
            SCOPED_TRACE(std::string(shell) + " " + place);
            const Ran ran = run_shell("export shade16 TERM=xterm SHELL=" + std::string(shell) + "; script -qefc 'timeout " +
                                      place + "-k 20 -s INT 1 $shade16 preview " + teapot() + "' /dev/null </dev/null");
            EXPECT_NE(ran.exit_code, 137);  // killed: the signal did not end it
            EXPECT_GT(count_of(ran.out, half_block), 0u);
            ASSERT_NE(ran.out.rfind(show), std::string::npos);
            EXPECT_GT(ran.out.rfind(show), ran.out.rfind(half_block));
        }
}

TEST(CliPreview, one_frame_without_cursor_movement_where_there_is_no_terminal) {
    const Ran ran = shade16_program("preview " + teapot());
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(count_of(ran.out, half_block), 80u * 23);
    EXPECT_THAT(ran.out, EndsWith("\033[0m\n"));
    for (const char* movement : {hide, "\r", "\033[22A", "\033[2J"}) EXPECT_THAT(ran.out, Not(HasSubstr(movement)));
    const Ran letters = run_shell("NO_COLOR=1 \"$shade16\" preview " + teapot());
    EXPECT_THAT(letters.out, Not(HasSubstr("\033")));
    EXPECT_EQ(letters.out.size(), 81u * 23);
    EXPECT_THAT(letters.out, HasSubstr("%%%"));
}

}  // namespace
}  // namespace shade16::host
