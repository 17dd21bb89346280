// Grey and dithered targets as a user asks for them.
#include <algorithm>
#include <set>

#include <gmock/gmock.h>

#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// The bytes of one render of a small teapot, 93 pixels wide: no whole number of bytes in gray4 and mono1.
std::string rendered(const std::string& ending, const std::string& options) {
    const ScratchDirectory scratch;
    const Ran ran =
        shade16_program("render " + teapot() + " --size 93x40 -o " + scratch.path("a" + ending) + " " + options);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return scratch.read("a" + ending);
}

void expect_refused(const std::string& arguments, const std::string& sentence) {
    const Ran ran = shade16_program(arguments);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr(sentence));
}

TEST(CliGray, raw_files_have_rows_that_begin_on_a_byte) {
    // The background 0x101820 has a luma of 22.5 of 255.
    EXPECT_EQ(rendered(".gray8", "--format gray8").size(), 93u * 40);
    EXPECT_THAT(rendered(".gray8", "--format gray8"), StartsWith("\x17\x17\x17"));
    EXPECT_EQ(rendered(".gray4", "--format gray4").size(), 47u * 40);
    EXPECT_THAT(rendered(".gray4", "--format gray4"), StartsWith("\x11\x11"));
    EXPECT_EQ(rendered(".mono1", "--format mono1").size(), 12u * 40);
    EXPECT_EQ(rendered(".gray4", "--format gray4 --scale 2").size(), 93u * 80);
    EXPECT_EQ(rendered(".mono1", "--format mono1 --scale 3").size(), 35u * 120);
}

TEST(CliGray, bands_and_both_engines_draw_every_format_and_dither) {
    for (const char* format : {"gray8", "gray4", "mono1"})
        for (const char* dither : {"none", "4x4", "8x8"}) {
            const std::string options = std::string("--format ") + format + " --dither " + dither;
            const std::string whole = rendered(std::string(".") + format, options);
            EXPECT_EQ(rendered(std::string(".") + format, options + " --bands 7"), whole) << options;
            const std::string reference = rendered(std::string(".") + format, options + " --engine reference");
            ASSERT_EQ(reference.size(), whole.size());
            int different = 0;
            for (std::size_t i = 0; i < whole.size(); ++i) different += whole[i] != reference[i];
            EXPECT_LT(different, static_cast<int>(whole.size()) / 20) << options;
        }
    EXPECT_EQ(rendered(".rgb565", "--dither 8x8 --bands 3"), rendered(".rgb565", "--dither 8x8"));
    EXPECT_NE(rendered(".rgb565", "--dither 8x8"), rendered(".rgb565", ""));
}

TEST(CliGray, a_film_of_one_bit_is_black_and_white) {
    const std::string film = rendered(".y4m", "--format mono1 --dither 4x4 --frames 2");
    const std::string luma = film.substr(film.find("FRAME\n") + 6, 93 * 40);
    EXPECT_EQ(std::set<char>(luma.begin(), luma.end()), (std::set<char>{'\0', '\xFF'}));
}

TEST(CliGray, what_does_not_fit_is_refused) {
    const ScratchDirectory scratch;
    const std::string render = "render " + teapot() + " -o ";
    expect_refused(render + scratch.path("a.png") + " --format rgb888 --dither 4x4",
                   "--dither 4x4: rgb888 shows every level there is; expected none, or a --format of fewer codes.");
    expect_refused(render + scratch.path("a.gray4"), "the ending is not that of --format rgb565; expected .rgb565.");
    expect_refused(render + scratch.path("a.rgb565") + " --format gray8",
                   "the ending is not that of --format gray8; expected .gray8.");
    expect_refused(render + scratch.path("a.mono1") + " --format rgb888",
                   "rgb888 has no raw file; expected --format mono1, or an output such as .png.");
    expect_refused(render + scratch.path("a.png") + " --dither 5x5", "--dither 5x5: expected none, 4x4 or 8x8");
    const std::string scene = scratch.write("s.toml", "[output]\nformat = \"rgb888\"\ndither = \"4x4\"\n");
    expect_refused("info " + scene, "rgb888");
    EXPECT_EQ(scratch.names().size(), 1u);
}

TEST(CliGray, a_scene_file_says_what_its_display_is) {
    const std::string scene = (source_directory() / "assets/scenes/oled.toml").string();
    const ScratchDirectory scratch;
    const Ran ran = shade16_program("render " + scene + " --frames 1 -o " + scratch.path("a.gray4"));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(scratch.read("a.gray4").size(), 64u * 64);
    const std::string dumped = shade16_program("render " + scene + " --dump-scene").out;
    EXPECT_THAT(dumped, HasSubstr("format = \"gray4\"\ndither = \"4x4\"\n"));
    EXPECT_EQ(shade16_program("render " + scene + " --frames 1 --format rgb888 -o " + scratch.path("a.png")).exit_code, 0) << "which has nothing to dither";
    EXPECT_THAT(shade16_program("info " + scene).out, HasSubstr("RAM of one band in gray4, 4 bits a pixel"));
    const Ran compared = shade16_program("compare --quiet --frames 2 " + scene);
    EXPECT_EQ(compared.exit_code, 0);
    EXPECT_THAT(compared.out, HasSubstr("(iii) The finished gray4 picture"));
}

TEST(CliGray, every_grey_format_keeps_every_promise) {
    const std::string scene = (source_directory() / "assets/scenes/everything.toml").string();
    for (const char* format : {"gray8", "gray4", "mono1"}) {
        const Ran ran = shade16_program("compare --quiet --frames 1 " + scene + " --format " + format);
        EXPECT_EQ(ran.exit_code, 0) << ran.out;
        EXPECT_THAT(ran.out, HasSubstr("Verdict: every promise is kept."));
    }
}

}  // namespace
}  // namespace shade16::host
