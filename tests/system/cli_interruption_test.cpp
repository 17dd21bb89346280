// A reader that goes away, and a user who does not want to wait.
#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(CliInterruption, a_closed_pipe_is_no_error) {
    const ScratchDirectory scratch;
    for (const std::string& command : {"render " + teapot() + " -o -", "render " + teapot() + " -o /dev/stdout"}) {
        const Ran ran =
            run_shell("{ \"$shade16\" " + command + "; echo $? >" + scratch.path("status") + "; } | head -c 100");
        EXPECT_EQ(ran.out.size(), 100u);
        EXPECT_THAT(ran.err, IsEmpty());
        EXPECT_EQ(scratch.read("status"), "0\n");
    }
    for (const std::string& command : {"compare " + teapot(), std::string("--help")}) {
        // The reader is gone before the program begins.
        const Ran ran =
            run_shell("{ sleep 0.2; \"$shade16\" " + command + "; echo $? >" + scratch.path("status") + "; } | true");
        EXPECT_THAT(ran.err, IsEmpty());
        EXPECT_EQ(scratch.read("status"), "0\n");
    }
}

pid_t start_long_render(const std::string& output) {
    const pid_t child = fork();
    if (child != 0) return child;
    const std::string model = teapot();
    execl(SHADE16_PROGRAM, "shade16", "render", model.c_str(), "-o", output.c_str(), "--frames", "100000", "--quiet",
          nullptr);
    _exit(127);
}

bool wait_for_a_file_in(const ScratchDirectory& scratch) {
    for (int i = 0; i < 1000; ++i) {
        if (!scratch.names().empty()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

TEST(CliInterruption, a_signal_in_mid_render_leaves_nothing) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP})
        for (const char* output : {"a.y4m", "a.apng", "a.rgb565"}) {
            const ScratchDirectory scratch;
            const pid_t child = start_long_render(scratch.path(output));
            ASSERT_GT(child, 0);
            EXPECT_TRUE(wait_for_a_file_in(scratch));
            EXPECT_EQ(kill(child, signal), 0);
            int status = 0;
            ASSERT_EQ(waitpid(child, &status, 0), child);
            EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
            EXPECT_THAT(scratch.names(), IsEmpty());
        }
}

TEST(CliInterruption, an_older_file_survives) {
    const ScratchDirectory scratch;
    scratch.write("a.y4m", "old");
    const pid_t child = start_long_render(scratch.path("a.y4m"));
    ASSERT_GT(child, 0);
    for (int i = 0; i < 1000 && scratch.names().size() < 2; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(child, SIGTERM);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_THAT(scratch.names(), ElementsAre("a.y4m"));
    EXPECT_EQ(scratch.read("a.y4m"), "old");
}

}  // namespace
}  // namespace shade16::host
