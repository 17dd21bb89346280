// What the program writes, read back by somebody else where there is one.
#include <cstdlib>

#include <gmock/gmock.h>

#include "tests/requirements.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

std::string scene_file(const std::string& name) { return (source_directory() / "assets/scenes" / (name + ".toml")).string(); }

/// The bytes of a small picture of a scene.
std::string of_scene(const std::string& name, const std::string& options) {
    const ScratchDirectory scratch;
    EXPECT_EQ(shade16_program("render " + scene_file(name) + " --frames 1 --size 96x40 -o " + scratch.path("a.png") + " " + options).exit_code, 0);
    return scratch.read("a.png");
}

/// The bytes of one render of a small teapot.
std::string rendered(const std::string& ending, const std::string& options) {
    const ScratchDirectory scratch;
    const Ran ran =
        shade16_program("render " + teapot() + " --size 96x80 -o " + scratch.path("a" + ending) + " " + options);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.err, IsEmpty());
    return scratch.read("a" + ending);
}

std::string swapped(std::string bytes) {
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
    return bytes;
}

TEST(CliOutput, ffmpeg_reads_the_y4m_and_sees_the_colours_of_the_png) {
    if (!has_program("ffmpeg") || !has_program("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed.";
    const ScratchDirectory scratch;
    const std::string render = "render " + teapot() + " --size 90x60 --frames 5 --fps 25 --quiet -o ";
    ASSERT_EQ(shade16_program(render + scratch.path("a.y4m")).exit_code, 0);
    ASSERT_EQ(shade16_program(render + scratch.path("a.png")).exit_code, 0);
    EXPECT_THAT(scratch.names(),
                ElementsAre("a-0000.png", "a-0001.png", "a-0002.png", "a-0003.png", "a-0004.png", "a.y4m"));

    const std::string probe = run_shell("ffprobe -v error -count_frames -show_streams " + scratch.path("a.y4m")).out;
    for (const char* line : {"nb_read_frames=5\n", "width=90\n", "height=60\n", "pix_fmt=yuv444p\n", "color_range=pc\n",
                             "r_frame_rate=25/1\n"})
        EXPECT_THAT(probe, HasSubstr(line));

    const std::string film =
        run_shell("ffmpeg -v error -i " + scratch.path("a.y4m") + " -pix_fmt rgb24 -f rawvideo -").out;
    const std::string pictures =
        run_shell("ffmpeg -v error -i " + scratch.path("a-%04d.png") + " -pix_fmt rgb24 -f rawvideo -").out;
    ASSERT_EQ(film.size(), 5u * 90 * 60 * 3);
    ASSERT_EQ(pictures.size(), film.size());
    int largest = 0;
    for (std::size_t i = 0; i < film.size(); ++i)
        largest = std::max(largest, std::abs(static_cast<uint8_t>(film[i]) - static_cast<uint8_t>(pictures[i])));
    EXPECT_LE(largest, 2);
}

TEST(CliOutput, the_look_of_all_materials_changes_the_picture) {
    const std::string plain = rendered(".png", ""), phong = rendered(".png", "--shading phong");
    EXPECT_NE(phong, plain);
    EXPECT_NE(rendered(".png", "--shading phong --normals spherical"), phong);
    EXPECT_NE(rendered(".png", "--reflection phong"), plain);
    EXPECT_EQ(rendered(".png", "--reflection blinn_phong --normals linear --light-table none"), plain) << "the teapot's own";
    EXPECT_NE(of_scene("textured_cube", "--filter nearest"), of_scene("textured_cube", "--filter bilinear"));
    EXPECT_NE(of_scene("textured_cube", "--mapping affine"), of_scene("textured_cube", "--mapping perspective"));
    EXPECT_NE(of_scene("tables", "--light-table none"), of_scene("tables", "--light-table nearest"));
}

TEST(CliOutput, says_which_light_table_is_not_used_and_why) {
    const auto said = [](const std::string& scene, const std::string& options) {
        const ScratchDirectory scratch;
        return shade16_program("render " + scene + " --frames 1 --size 40x30 -o " + scratch.path("a.png") + " --light-table nearest " + options).err;
    };
    const std::string tables = scene_file("tables");
    EXPECT_EQ(said(teapot(), "--shading phong"), "warning: Object 1 does not use its light table: a point or spot light shines.\n");
    EXPECT_EQ(said(teapot(), ""), "warning: Object 1 does not use its light table: its shading is not phong.\n");
    EXPECT_THAT(said(scene_file("textured_cube"), "--shading phong"), HasSubstr("Object 1, like 2 more, does not use its light table: it has a texture"));
    EXPECT_EQ(said(tables, ""), "");
    const ScratchDirectory scratch;
    EXPECT_EQ(run_shell("sed 's/^viewer = .*//; s/^\\[camera\\]/&\\nviewer = \"local\"/' " + tables + " >" + scratch.path("local.toml")).exit_code, 0);
    EXPECT_THAT(said(scratch.path("local.toml"), ""), HasSubstr("its highlights are seen by a local viewer."));
}

TEST(CliOutput, standard_output_is_the_file_and_nothing_else) {
    const Ran ran = shade16_program("render " + teapot() + " --size 96x80 --frames 3 --verbose -o -");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.out, rendered(".y4m", "--frames 3"));
    EXPECT_THAT(ran.err, HasSubstr("of 255"));
}

TEST(CliOutput, a_film_has_90_frames_and_a_picture_one) {
    const ScratchDirectory scratch;
    const std::string film = rendered(".y4m", "");
    EXPECT_THAT(film, StartsWith("YUV4MPEG2 W96 H80 F30:1 "));
    EXPECT_EQ(film.size(), film.find('\n') + 1 + 90 * (6 + 96 * 80 * 3));
    EXPECT_EQ(rendered(".rgb565", "").size(), 96u * 80 * 2);
    EXPECT_EQ(shade16_program("render " + teapot() + " -o " + scratch.path("a.png")).out, "");
    EXPECT_THAT(scratch.names(), ElementsAre("a.png"));
    EXPECT_THAT(shade16_program("render " + teapot() + " --size 20x20 --frames 3 -o " + scratch.path("b.png")).out,
                HasSubstr("3 frames of 20x20 pixels, numbered from -0000 to -0002"));
}

TEST(CliOutput, bands_draw_the_same_bytes) {
    for (const char* tier : {"lowp", "mediump", "highp"})
        for (const char* format : {"rgb565", "rgb565_swapped"}) {
            const std::string options = std::string("--frames 2 --tier ") + tier + " --format " + format;
            const std::string whole = rendered(".rgb565", options);
            for (const char* rows : {"1", "7", "64", "2048"})
                EXPECT_EQ(rendered(".rgb565", options + " --bands " + rows), whole) << options << " --bands " << rows;
        }
}

TEST(CliOutput, swapped_is_the_same_picture_in_another_byte_order) {
    for (const char* engine : {"fixed", "reference"}) {
        const std::string options = std::string("--engine ") + engine + " --format ";
        EXPECT_EQ(rendered(".rgb565", options + "rgb565_swapped"), swapped(rendered(".rgb565", options + "rgb565")));
        EXPECT_EQ(rendered(".png", std::string("--engine ") + engine + " --format rgb565_swapped"),
                  rendered(".png", std::string("--engine ") + engine + " --format rgb565"));
    }
}

TEST(CliOutput, raw_begins_with_the_low_byte_of_the_background) {
    // 0x101820 is 5-6-5 codes 2, 6, 4: 0x10C4.
    EXPECT_THAT(rendered(".rgb565", ""), StartsWith("\xC4\x10\xC4\x10"));
}

TEST(CliOutput, every_choice_draws_another_picture) {
    const std::string usual = rendered(".png", "");
    for (const char* options :
         {"--engine reference", "--tier lowp", "--tier highp", "--format rgb888", "--shading flat",
          "--component ambient", "--component diffuse", "--component specular"})
        EXPECT_NE(rendered(".png", options), usual) << options;
    EXPECT_EQ(rendered(".png", "--shading gouraud"), usual);  // the material's own
    EXPECT_EQ(rendered(".png", "--component all"), usual);
}

TEST(CliOutput, verbose_prints_a_fit_within_the_wanted_limits) {
    const ScratchDirectory scratch;
    for (const char* size : {"320x240", "240x320", "128x128"}) {
        const Ran ran =
            shade16_program("render " + teapot() + " --verbose -o " + scratch.path("a.png") + " --size " + size);
        int least = 0, largest = 0, brightest = 0;
        double saturated = 100;
        const char* const line =
            "fit: the model covers %d to %d %% of the frame's width or height (the larger of both) over a turn "
            "fit: the brightest code is %d of 255 fit: at most %lf %%";
        ASSERT_EQ(std::sscanf(ran.out.c_str(), line, &least, &largest, &brightest, &saturated), 4) << ran.out;
        EXPECT_GE(least, 35);
        EXPECT_LE(largest, 70);
        EXPECT_GE(brightest, 240);
        EXPECT_LT(saturated, 1);
    }
}

TEST(CliOutput, warnings_are_on_standard_error_unless_quiet) {
    const ScratchDirectory scratch;
    const std::string model = scratch.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
    const std::string command = "render " + model + " -o " + scratch.path("a.png");
    EXPECT_EQ(shade16_program(command).err, "warning: 1 triangle without area was skipped.\n");
    EXPECT_EQ(shade16_program(command + " --quiet").err, "");
    EXPECT_THAT(shade16_program("bake " + model + " -o -").err, StartsWith("warning: 1 triangle"));
    EXPECT_THAT(shade16_program("compare " + model).err, StartsWith("warning: 1 triangle"));
}

TEST(CliOutput, bake_says_what_it_made) {
    const ScratchDirectory scratch;
    const Ran ran = shade16_program("bake " + teapot() + " -o " + scratch.path("pot.hpp"));
    EXPECT_EQ(ran.exit_code, 0);
    for (const char* part :
         {"529 vertices, 992 triangles, 12300 bytes of flash", "positions by at most 0.0007", "not convex"})
        EXPECT_THAT(ran.out, HasSubstr(part));
    EXPECT_THAT(scratch.read("pot.hpp"), HasSubstr("inline constexpr shade16::Mesh pot{"));
    EXPECT_THAT(shade16_program("bake " + teapot() + " -o - --name kettle").out, HasSubstr("shade16::Mesh kettle{"));
    EXPECT_THAT(shade16_program("bake " + teapot() + " -o -").err, HasSubstr("bytes of flash"));
    EXPECT_THAT(shade16_program("bake " + teapot() + " -o -").out, Not(HasSubstr("normals by")));
}

TEST(CliOutput, bake_says_what_it_made_of_a_scene_file) {
    const ScratchDirectory scratch;
    const std::string bake = "bake " + (source_directory() / "assets/scenes/s4.toml").string() + " -o ";
    EXPECT_THAT(shade16_program(bake + scratch.path("lamps.hpp")).out,
                HasSubstr("lamps.hpp: 482 vertices, 960 triangles, 11544 bytes of flash\n"
                          "  1 object, 4 lights, 1 frame of 320x240 pixels\n"));
    EXPECT_THAT(scratch.read("lamps.hpp"), HasSubstr("namespace assets::lamps {"));
    EXPECT_THAT(shade16_program(bake + "- --name shown --quiet").out, HasSubstr("namespace assets::shown {"));
    EXPECT_THAT(shade16_program(bake + "- --quiet").err, IsEmpty());
    EXPECT_THAT(shade16_program(bake + "-").err, HasSubstr("bytes of flash"));
}

TEST(CliOutput, help_begins_with_examples) {
    for (const char* arguments : {"--help", "render --help", "compare --help", "bake --help", "info --help",
                                  "preview --help", "show --help", "-h", "render -h"}) {
        const Ran ran = shade16_program(arguments);
        EXPECT_EQ(ran.exit_code, 0);
        EXPECT_THAT(ran.out, StartsWith("Examples:\n  shade16 "));
        EXPECT_THAT(ran.out, HasSubstr("Exit codes: 0 done"));
        EXPECT_THAT(ran.err, IsEmpty());
    }
    EXPECT_THAT(shade16_program("--version").out, testing::MatchesRegex("shade16 [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

}  // namespace
}  // namespace shade16::host
