// Animated PNG and magnified pixels, read back by ffmpeg.
#include <gmock/gmock.h>

#include "tests/requirements.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string decoded(const std::string& file) {
    return run_shell("ffmpeg -v error -i " + file + " -pix_fmt rgb24 -f rawvideo -").out;
}

TEST(CliApng, ffmpeg_reads_every_frame_with_the_pixels_of_the_png) {
    if (!has_program("ffmpeg") || !has_program("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed.";
    const ScratchDirectory scratch;
    const std::string render = "render " + teapot() + " --size 91x60 --frames 7 --fps 25 -o ";
    const Ran ran = shade16_program(render + scratch.path("a.apng"));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("a.apng: 7 frames of 91x60 pixels at 25 frames a second"));
    ASSERT_EQ(shade16_program(render + scratch.path("b.png")).exit_code, 0);

    const std::string probe = run_shell("ffprobe -v error -count_frames -show_streams " + scratch.path("a.apng")).out;
    for (const char* line :
         {"codec_name=apng\n", "nb_read_frames=7\n", "width=91\n", "height=60\n", "r_frame_rate=25/1\n"})
        EXPECT_THAT(probe, HasSubstr(line));
    const std::string film = decoded(scratch.path("a.apng"));
    EXPECT_EQ(film.size(), 7u * 91 * 60 * 3);
    EXPECT_TRUE(film == decoded(scratch.path("b-%04d.png")));
}

TEST(CliApng, a_reader_without_animation_sees_the_first_frame) {
    if (!has_program("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed.";
    const ScratchDirectory scratch;
    const std::string render = "render " + teapot() + " --size 40x30 -o ";
    ASSERT_EQ(shade16_program(render + scratch.path("a.apng") + " --frames 3").exit_code, 0);
    ASSERT_EQ(shade16_program(render + scratch.path("b.png")).exit_code, 0);
    const std::string first = run_shell("ffmpeg -v error -f png_pipe -i " + scratch.path("a.apng") +
                                        " -frames:v 1 -pix_fmt rgb24 -f rawvideo -")
                                  .out;
    EXPECT_TRUE(first == decoded(scratch.path("b.png")));
}

TEST(CliScale, every_pixel_becomes_a_square) {
    const ScratchDirectory scratch;
    const std::string render = "render --quiet " + teapot() + " --size 20x15 -o ";
    ASSERT_EQ(shade16_program(render + scratch.path("a.rgb565")).exit_code, 0);
    ASSERT_EQ(shade16_program(render + scratch.path("b.rgb565") + " --scale 3").exit_code, 0);
    const std::string small = scratch.read("a.rgb565"), large = scratch.read("b.rgb565");
    ASSERT_EQ(large.size(), 9 * small.size());
    for (std::size_t y = 0; y < 45; ++y)
        for (std::size_t x = 0; x < 60; ++x)
            ASSERT_EQ(large.substr(2 * (60 * y + x), 2), small.substr(2 * (20 * (y / 3) + x / 3), 2)) << x << " " << y;
}

TEST(CliScale, refuses_what_makes_no_sense) {
    const ScratchDirectory scratch;
    const std::string render = "render " + teapot() + " -o " + scratch.path("a.png") + " --scale ";
    for (const char* times : {"0", "17", "1.5"}) {
        const Ran ran = shade16_program(render + times);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_THAT(ran.err, HasSubstr("expected a whole number from 1 to 16."));
    }
    EXPECT_THAT(shade16_program(render + "16 --size 513x1").err, HasSubstr("makes 8208 pixels of 513"));
    EXPECT_THAT(scratch.names(), IsEmpty());
}

}  // namespace
}  // namespace shade16::host
