#include "host_sim/io/atomic_file.hpp"

#include <array>

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/requirements.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(AtomicFile, appears_under_its_name_at_commit) {
    const ScratchDirectory scratch;
    AtomicFile file(scratch.path("out.bin"));
    file.write("half");
    ASSERT_EQ(scratch.names().size(), 1u);
    EXPECT_THAT(scratch.names()[0], StartsWith("out.bin.tmp-"));
    file.write(" and half");
    file.commit();
    EXPECT_THAT(scratch.names(), ElementsAre("out.bin"));
    EXPECT_EQ(scratch.read("out.bin"), "half and half");
}

TEST(AtomicFile, leaves_nothing_without_commit) {
    const ScratchDirectory scratch;
    { AtomicFile(scratch.path("out.bin")).write("half"); }
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(AtomicFile, keeps_the_old_file_until_commit) {
    const ScratchDirectory scratch;
    scratch.write("out.bin", "old");
    {
        AtomicFile file(scratch.path("out.bin"));
        file.write("new");
    }
    EXPECT_EQ(scratch.read("out.bin"), "old");
    write_file(scratch.path("out.bin"), "new");
    EXPECT_EQ(scratch.read("out.bin"), "new");
}

TEST(AtomicFile, is_as_public_as_the_umask_says) {
    const ScratchDirectory scratch;
    const mode_t before = umask(022);
    write_file(scratch.path("out.bin"), "x");
    umask(before);
    struct stat status {};
    ASSERT_EQ(stat(scratch.path("out.bin").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0644u);
}

TEST(AtomicFile, writes_through_a_symbolic_link) {
    const ScratchDirectory scratch;
    scratch.write("target.bin", "old");
    std::filesystem::create_symlink("target.bin", scratch.path("link.bin"));
    write_file(scratch.path("link.bin"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link.bin")));
    EXPECT_EQ(scratch.read("target.bin"), "new");
}

TEST(AtomicFile, unfinished_files_can_be_removed_by_a_signal_handler) {
    const ScratchDirectory scratch;
    AtomicFile first(scratch.path("a.bin"));
    AtomicFile second(scratch.path("b.bin"));
    write_file(scratch.path("c.bin"), "finished");
    remove_unfinished_files();
    EXPECT_THAT(scratch.names(), ElementsAre("c.bin"));
}

TEST(AtomicFile, more_unfinished_files_than_are_remembered_still_vanish) {
    const ScratchDirectory scratch;
    {
        std::vector<std::unique_ptr<OutputStream>> files;
        for (int i = 0; i < 40; ++i) files.push_back(open_output(scratch.path(fmt::format("f{}", i))));
        EXPECT_EQ(scratch.names().size(), 40u);
    }
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(AtomicFile, a_missing_directory_is_an_io_error) {
    const ScratchDirectory scratch;
    const std::string said = complaint([&] { open_output(scratch.path("no/out.bin")); });
    EXPECT_THAT(said, StartsWith("3: "));
    EXPECT_THAT(said, HasSubstr("no/out.bin: cannot be created: No such file or directory."));
}

TEST(AtomicFile, a_directory_is_no_output) {
    const ScratchDirectory scratch;
    const std::string said = complaint([&] { open_output(scratch.path(".")); });
    EXPECT_THAT(said, StartsWith("3: "));
    EXPECT_THAT(said, HasSubstr("is a directory; expected the name of a file."));
}

TEST(AtomicFile, a_target_that_became_a_directory_leaves_no_file) {
    const ScratchDirectory scratch;
    {
        AtomicFile file(scratch.path("out"));
        std::filesystem::create_directory(scratch.path("out"));
        EXPECT_THAT(complaint([&] { file.commit(); }), HasSubstr("out: cannot be created: Is a directory."));
    }
    EXPECT_THAT(scratch.names(), ElementsAre("out"));
}

TEST(DirectStream, a_device_is_written_and_not_replaced) {
    write_file("/dev/null", "gone");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    if (!has_file("/dev/full")) GTEST_SKIP() << "This system has no /dev/full.";
    EXPECT_THAT(complaint([] { write_file("/dev/full", "x"); }),
                StartsWith("3: /dev/full: cannot be written: No space left"));
}

/// Standard output is the given descriptor while this lives.
class OutputTo {
public:
    explicit OutputTo(int descriptor) : before_(dup(STDOUT_FILENO)) {
        std::fflush(stdout);
        dup2(descriptor, STDOUT_FILENO);
    }
    ~OutputTo() {
        dup2(before_, STDOUT_FILENO);
        close(before_);
    }
    OutputTo(const OutputTo&) = delete;
    OutputTo& operator=(const OutputTo&) = delete;

private:
    int before_;
};

TEST(DirectStream, a_dash_is_standard_output) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    {
        const OutputTo pipe_end(ends[1]);
        write_file("-", "hello");
    }
    std::array<char, 8> text{};
    EXPECT_EQ(read(ends[0], text.data(), text.size()), 5);
    EXPECT_STREQ(text.data(), "hello");
    close(ends[0]);
    close(ends[1]);
}

TEST(DirectStream, a_reader_that_leaves_is_a_quiet_end) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    close(ends[0]);
    bool closed = false;
    {
        const OutputTo pipe_end(ends[1]);
        try {
            write_file("-", "hello");
        } catch (const ClosedPipe&) {
            closed = true;
        }
    }
    EXPECT_TRUE(closed);
    close(ends[1]);
}

}  // namespace
}  // namespace shade16::host
