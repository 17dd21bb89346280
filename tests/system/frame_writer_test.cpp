#include "host_sim/io/frame_writer.hpp"

#include <gmock/gmock.h>
#include <png.h>

#include "tests/requirements.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

Image grey(int width, int height, uint8_t level) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<uint8_t>(3 * pixels, level), std::vector<uint8_t>(2 * pixels, level)};
}

void write_frames(const std::string& path, const std::vector<Image>& frames) {
    const auto writer = open_writer(path, frames[0].width, frames[0].height, static_cast<int>(frames.size()), 30);
    for (const Image& frame : frames) writer->write(frame);
    writer->finish();
}

TEST(FrameWriter, y4m_has_a_header_and_three_planes_a_frame) {
    const ScratchDirectory scratch;
    write_frames(scratch.path("a.y4m"), {grey(2, 1, 0), grey(2, 1, 200)});
    EXPECT_EQ(scratch.read("a.y4m"),
              "YUV4MPEG2 W2 H1 F30:1 Ip A1:1 C444 XCOLORRANGE=FULL\n"
              "FRAME\n" +
                  std::string("\0\0\x80\x80\x80\x80", 6) + "FRAME\n\xC8\xC8\x80\x80\x80\x80");
}

TEST(FrameWriter, y4m_primaries_are_bt601_full_range) {
    const ScratchDirectory scratch;
    const Image primaries{3, 1, {255, 0, 0, 0, 255, 0, 0, 0, 255}, {}};
    write_frames(scratch.path("a.y4m"), {primaries});
    EXPECT_THAT(scratch.read("a.y4m"), EndsWith("FRAME\n\x4C\x96\x1D\x55\x2C\xFF\xFF\x15\x6B"));
}

TEST(FrameWriter, every_rgb565_colour_survives_y4m_and_ffmpeg) {
    if (!has_program("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed.";
    const ScratchDirectory scratch;
    const auto channel = [](unsigned int code, unsigned int bits) {
        return static_cast<uint8_t>((code << (8 - bits)) | (code >> (2 * bits - 8)));
    };
    Image all{256, 256, {}, {}};
    for (unsigned int color = 0; color < 65536; ++color)
        for (const uint8_t c : {channel(color >> 11, 5), channel(color >> 5 & 63, 6), channel(color & 31, 5)})
            all.rgb.push_back(c);
    write_frames(scratch.path("a.y4m"), {all});
    const std::string command =
        "ffmpeg -v error -i " + scratch.path("a.y4m") + " -pix_fmt rgb24 -f rawvideo " + scratch.path("back.rgb");
    ASSERT_EQ(std::system(command.c_str()), 0);

    const std::string back = scratch.read("back.rgb");
    ASSERT_EQ(back.size(), all.rgb.size());
    int wrong = 0, largest = 0;
    for (std::size_t i = 0; i < back.size(); ++i) {
        const int before = all.rgb[i], after = static_cast<uint8_t>(back[i]), levels = i % 3 == 1 ? 63 : 31;
        largest = std::max(largest, std::abs(before - after));
        wrong += (before * levels + 127) / 255 != (after * levels + 127) / 255;
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(largest, 1);
}

TEST(FrameWriter, png_comes_back) {
    const ScratchDirectory scratch;
    const Image frame{2, 2, {1, 2, 3, 40, 50, 60, 255, 0, 128, 9, 8, 7}, {}};
    write_frames(scratch.path("a.png"), {frame});
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_file(&png, scratch.path("a.png").c_str()));
    png.format = PNG_FORMAT_RGB;
    std::vector<uint8_t> rgb(PNG_IMAGE_SIZE(png));
    ASSERT_TRUE(png_image_finish_read(&png, nullptr, rgb.data(), 0, nullptr));
    EXPECT_EQ(rgb, frame.rgb);
    EXPECT_EQ(png.width, 2u);
}

TEST(FrameWriter, several_pngs_are_numbered) {
    const ScratchDirectory scratch;
    write_frames(scratch.path("spin.png"), {grey(2, 2, 1), grey(2, 2, 2), grey(2, 2, 3)});
    EXPECT_THAT(scratch.names(), ElementsAre("spin-0000.png", "spin-0001.png", "spin-0002.png"));
}

TEST(FrameWriter, raw_is_the_targets_bytes) {
    const ScratchDirectory scratch;
    write_frames(scratch.path("a.RGB565"), {{1, 1, {0, 0, 0}, {0x12, 0x34}}, {1, 1, {0, 0, 0}, {0x56, 0x78}}});
    EXPECT_EQ(scratch.read("a.RGB565"), "\x12\x34\x56\x78");
}

TEST(FrameWriter, raw_of_another_pixel_size_is_refused_and_leaves_no_file) {
    const ScratchDirectory scratch;
    const std::string said = complaint([&] { write_frames(scratch.path("a.rgb565"), {{2, 2, {}, {1, 2, 3, 4}}}); });
    EXPECT_EQ(said, "2: " + scratch.path("a.rgb565") +
                        ": .rgb565 holds 8 bytes a frame, but this target's frame has 4; "
                        "expected a 16-bit pixel format.");
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(FrameWriter, an_unknown_ending_lists_the_known_ones) {
    const ScratchDirectory scratch;
    EXPECT_EQ(complaint([] { open_writer("spin.gif", 1, 1, 1, 30); }),
              "2: spin.gif: the ending '.gif' names no known format; expected .y4m, .apng, .png or a raw one (.rgb565, .gray8, "
              ".gray4, .mono1), or '-' for Y4M on "
              "standard output.");
    EXPECT_THAT(complaint([] { open_writer("spin", 1, 1, 1, 30); }), HasSubstr("a name without an ending"));
}

TEST(FrameWriter, an_abandoned_stream_leaves_no_file) {
    const ScratchDirectory scratch;
    { open_writer(scratch.path("a.y4m"), 2, 2, 9, 30)->write(grey(2, 2, 1)); }
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(FrameWriter, a_missing_directory_is_an_io_error) {
    const ScratchDirectory scratch;
    for (const char* name : {"no/a.y4m", "no/a.png", "no/a.rgb565"})
        EXPECT_THAT(
            complaint([&] { write_frames(scratch.path(name), {grey(2, 2, 1)}); }),
            testing::AllOf(testing::StartsWith("3: "), HasSubstr("cannot be created: No such file or directory")));
    EXPECT_THAT(scratch.names(), IsEmpty());
}

}  // namespace
}  // namespace shade16::host
