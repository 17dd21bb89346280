// The comparison as a user sees it, on this project's model and on somebody else's.
#include <cstdlib>

#include <gmock/gmock.h>

#include "tests/requirements.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* spider = "/usr/share/assimp/models/OBJ/spider.obj";  // Debian's assimp-testmodels

void expect_promises_kept(const std::string& model, const std::string& options) {
    SCOPED_TRACE(options);
    const Ran ran = shade16_program("compare --quiet " + model + " " + options);
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_THAT(ran.out, HasSubstr("Verdict: every promise is kept."));
    EXPECT_THAT(ran.out, Not(HasSubstr("BROKEN")));
    EXPECT_THAT(ran.err, IsEmpty());
}

TEST(CliCompare, the_teapot_keeps_every_promise) {
    expect_promises_kept(teapot(), "");
    expect_promises_kept(teapot(), "--shading flat --size 160x160 --frames 3");
    expect_promises_kept(teapot(), "--size 1x1 --frames 1");
}

TEST(CliCompare, lamps_and_every_component_keep_every_promise) {
    const std::string lamps = (source_directory() / "assets/scenes/lamps.toml").string();
    expect_promises_kept(lamps, "--frames 3");
    for (const char* component : {"ambient", "diffuse", "specular"})
        expect_promises_kept(lamps, std::string("--frames 1 --size 80x60 --component ") + component);
    expect_promises_kept(lamps, "--frames 1 --size 80x60 --shading phong --tier highp");
}

TEST(CliCompare, a_component_that_is_not_there_is_refused) {
    const ScratchDirectory scratch;
    const std::string scene = scratch.write("dark.toml", "[meshes.ball]\nshape = \"sphere\"\n[[objects]]\nmesh = \"ball\"\n");
    const Ran ran = shade16_program("compare --quiet " + scene + " --component specular");
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr("--component specular: the scene has no such light; expected a component that it has."));
}

TEST(CliCompare, the_table_says_what_it_means) {
    const std::string table = shade16_program("compare " + teapot() + " --frames 1").out;
    for (const char* part : {"one level is 1/255 of a colour channel", "(i) ", "(ii) ", "(iii) ", "0.75; 2.5", "lowp",
                             "mediump", "highp", "one code of RGB565 is 8.2 levels", "of 320x240 pixels"})
        EXPECT_THAT(table, HasSubstr(part));
}

TEST(CliCompare, one_tier_alone) {
    const std::string table = shade16_program("compare " + teapot() + " --frames 1 --tier highp").out;
    EXPECT_THAT(table, HasSubstr("highp"));
    EXPECT_THAT(table, Not(HasSubstr("lowp")));
}

TEST(CliCompare, a_part_that_rounding_removes_is_not_missed) {
    const ScratchDirectory scratch;
    scratch.write("m.mtl", "newmtl speck\nKd 1 0 0\nnewmtl wall\nKd 0 1 0\n");
    const std::string model =
        scratch.write("m.obj",
                      "mtllib m.mtl\nusemtl speck\nv 0 0 0\nv 0.00001 0 0\nv 0 0.00001 0\nf 1 2 3\n"
                      "usemtl wall\nv -9000 -9000 0\nv 9000 -9000 99\nv 0 9000 0\nf 4 5 6\n");
    const std::string fixed = shade16_program("render --quiet " + model + " -o - --frames 1 --size 64x64").out;
    const std::string reference =
        shade16_program("render --quiet " + model + " -o - --frames 1 --size 64x64 --engine reference").out;
    ASSERT_EQ(fixed.size(), reference.size());
    int largest = 0;
    std::size_t far = 0;
    for (std::size_t i = 0; i < fixed.size(); ++i) {
        const int difference = std::abs(static_cast<uint8_t>(fixed[i]) - static_cast<uint8_t>(reference[i]));
        largest = std::max(largest, difference);
        far += difference > 10;
    }
    EXPECT_GT(largest, 0);
    EXPECT_LT(far, fixed.size() / 100);
}

TEST(CliCompare, the_spider_renders_and_keeps_every_promise) {
    if (!has_file(spider)) GTEST_SKIP() << "assimp-testmodels is not installed.";
    expect_promises_kept(spider, "");
    expect_promises_kept(spider, "--shading flat --size 240x320 --frames 4");
    const ScratchDirectory scratch;
    const Ran ran = shade16_program(std::string("render ") + spider + " -o " + scratch.path("a.png"));
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_THAT(ran.err, HasSubstr("warning: 56 triangles without area were skipped."));
    EXPECT_THAT(scratch.names(), testing::ElementsAre("a.png"));
}

}  // namespace
}  // namespace shade16::host
