// What the program refuses: in one sentence, with the right exit code, and without leaving a file behind.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/requirements.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// One sentence: a line of its own, and a full stop or a question mark at its end.
void expect_refusal(const Ran& ran, int exit_code, const std::string& sentence) {
    EXPECT_EQ(ran.exit_code, exit_code);
    EXPECT_THAT(ran.err, StartsWith("shade16: "));
    EXPECT_THAT(ran.err, HasSubstr(sentence));
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_TRUE(ran.err.ends_with(".\n") || ran.err.ends_with("?\n")) << ran.err;
    EXPECT_THAT(ran.out, IsEmpty());
}

void expect_model_refused(const std::string& obj, const std::string& sentence) {
    const ScratchDirectory scratch;
    const std::string model = scratch.write("m.obj", obj);
    for (const char* output : {"a.y4m", "a.png", "a.rgb565"})
        expect_refusal(shade16_program("render " + model + " -o " + scratch.path(output)), 2, sentence);
    expect_refusal(shade16_program("bake " + model + " -o " + scratch.path("a.hpp")), 2, sentence);
    expect_refusal(shade16_program("compare " + model), 2, sentence);
    expect_refusal(shade16_program("render " + model + " -o -"), 2, sentence);
    EXPECT_THAT(scratch.names(), ElementsAre("m.obj"));
}

/// `arguments` after `render teapot.obj -o a.png`.
void expect_usage_refused(const std::string& arguments, const std::string& sentence) {
    const ScratchDirectory scratch;
    SCOPED_TRACE(arguments);
    expect_refusal(shade16_program("render " + teapot() + " -o " + scratch.path("a.png") + " " + arguments), 2,
                   sentence);
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(CliRefusal, a_missing_model) {
    const ScratchDirectory scratch;
    expect_refusal(shade16_program("render " + scratch.path("no.obj") + " -o " + scratch.path("a.png")), 2,
                   "no.obj: cannot be opened: No such file or directory.");
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(CliRefusal, a_model_that_cannot_be_read) {
    const ScratchDirectory scratch;
    expect_refusal(shade16_program("compare " + scratch.path("")), 2, "is a directory; expected a text file.");
    const std::string unmapped = "/proc/self/mem";  // opens, but reading its first byte fails
    if (std::filesystem::exists(unmapped))
        expect_refusal(shade16_program("compare " + unmapped), 3, unmapped + ": cannot be read to its end.");
}

TEST(CliRefusal, a_model_that_the_user_may_not_read) {
    std::string as_user;
    if (geteuid() == 0) {  // root reads every file, unless without the rights that make it so
        if (!has_program("setpriv")) GTEST_SKIP() << "root reads every file, and setpriv is not installed.";
        as_user = "setpriv --bounding-set=-dac_override,-dac_read_search --inh-caps=-dac_override,-dac_read_search ";
    }
    const ScratchDirectory scratch;
    const std::string model = scratch.write("m.obj", triangle);
    std::filesystem::permissions(model, std::filesystem::perms::none);
    expect_refusal(run_shell(as_user + "\"$shade16\" compare " + model), 2, "m.obj: cannot be opened: Permission denied.");
}

TEST(CliRefusal, a_model_without_faces) {
    expect_model_refused("v 0 0 0\n", "m.obj: has no faces; expected at least one line such as 'f 1 2 3'.");
    expect_model_refused("", "m.obj: has no faces");
}

TEST(CliRefusal, an_index_out_of_range) {
    expect_model_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
                         "m.obj, line 4: a face refers to vertex 4; expected 1 to 3, as the file has 3.");
    expect_model_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4: a face refers to vertex 0");
    expect_model_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", "line 4: a face refers to vertex -4");
}

TEST(CliRefusal, coordinates_that_are_none_or_huge) {
    expect_model_refused("v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                         "m.obj, line 1: the coordinate 'nan' is not a number");
    expect_model_refused("v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n",
                         "m.obj, line 2: the coordinate 'inf' is out of range");
    expect_model_refused("v 0 0 0\nv 1 0 0\nv 0 1e30 0\nf 1 2 3\n",
                         "m.obj, line 3: the coordinate '1e30' is out of range; expected -16384 to 16384.");
}

/// It would break the sentence, or tell the terminal what to do.
TEST(CliRefusal, control_characters_are_not_repeated) {
    expect_model_refused("v 0 \x1b[31m 0\n", "m.obj, line 1: the coordinate '?[31m' is not a number");
    const ScratchDirectory scratch;
    const std::string scene = scratch.write("s.toml", "\"first\\nsecond\" = 1\n");
    expect_refusal(shade16_program("render " + scene + " -o " + scratch.path("a.png")), 2, "s.toml:1: unknown key 'first?second'");
    scratch.write("a.mtl", "newmtl odd\x1b[31m\nKs 1 1 1\nNs 0\n");
    const std::string model = scratch.write("m.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl odd\x1b[31m\nf 1 2 3\n");
    const Ran ran = shade16_program("render " + model + " -o " + scratch.path("a.png"));
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_THAT(ran.err, HasSubstr("(material odd?[31m)."));
}

TEST(CliRefusal, more_vertices_than_16_bit_indices_reach) {
    constexpr int columns = 257, rows = 256;  // 65792
    std::string obj;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) obj += fmt::format("v {} {} {}\n", x, y, (x * y) % 7);
    for (int y = 0; y + 1 < rows; ++y)
        for (int x = 1; x < columns; ++x) {
            const int corner = y * columns + x;
            obj += fmt::format("f {} {} {} {}\n", corner, corner + 1, corner + columns + 1, corner + columns);
        }
    const ScratchDirectory scratch;
    const std::string model = scratch.write("m.obj", obj);
    const std::string sentence = "m.obj: the part 'default' has 65792 different vertices; expected at most 65535";
    expect_refusal(shade16_program("render " + model + " -o " + scratch.path("a.y4m")), 2, sentence);
    EXPECT_THAT(scratch.names(), ElementsAre("m.obj"));
}

TEST(CliRefusal, an_unwritable_output_is_a_failure_of_the_machine) {
    const ScratchDirectory scratch;
    std::filesystem::create_directory(scratch.path("d.png"));
    for (const char* output : {"no/a.png", "no/a.y4m", "no/a.rgb565"})
        expect_refusal(shade16_program("render " + teapot() + " -o " + scratch.path(output)), 3,
                       std::string(output) + ": cannot be created: No such file or directory.");
    expect_refusal(shade16_program("bake " + teapot() + " -o " + scratch.path("no/a.hpp")), 3,
                   "no/a.hpp: cannot be created");
    expect_refusal(shade16_program("render " + teapot() + " -o " + scratch.path("d.png")), 3, "d.png: is a directory");
    EXPECT_THAT(scratch.names(), ElementsAre("d.png"));
    for (const char* output : {".gray8", ".rgb565", ".png"})  // a name, and no ending
        expect_refusal(shade16_program("render " + teapot() + " -o " + scratch.path(output)), 2, "a name without an ending names no known format");
}

TEST(CliRefusal, a_full_disk) {
    if (!has_file("/dev/full")) GTEST_SKIP() << "there is no /dev/full.";
    for (const std::string& command : {"render " + teapot() + " -o -", "bake " + teapot() + " -o -",
                                       "compare " + teapot(), std::string("--help"), std::string("--version")}) {
        SCOPED_TRACE(command);
        expect_refusal(shade16_program(command + " >/dev/full"), 3,
                       "standard output: cannot be written: No space left");
    }
}

TEST(CliRefusal, a_size_of_zero_or_beyond_the_domain) {
    for (const std::string size : {"0x240", "320x0", "0x0", "2049x1", "1x2049", "99999999999x9", "-320x240", "320",
                                   "320x", "x240", "320x240x3", "320X240", "a", "''"})
        expect_usage_refused(
            "--size " + size,
            fmt::format("--size {}: expected WIDTHxHEIGHT, each from 1 to 2048 pixels", size == "''" ? "" : size));
    expect_refusal(shade16_program("compare " + teapot() + " --size 0x1"), 2, "--size 0x1: expected WIDTHxHEIGHT");
}

TEST(CliRefusal, numbers_out_of_range) {
    for (const char* option : {"--frames", "--fps", "--bands"})
        for (const char* number : {"0", "-1", "1.5", "x", "99999999999"})
            expect_usage_refused(fmt::format("{} {}", option, number),
                                 fmt::format("{} {}: expected a whole number from 1 to ", option, number));
}

TEST(CliRefusal, words_nobody_knows) {
    expect_usage_refused("--tier half", "--tier half: expected lowp, mediump or highp.");
    expect_usage_refused("--format rgb555", "--format rgb555: expected rgb565, rgb565_swapped, rgb888, gray8, gray4 or mono1; did you mean rgb565?");
    expect_usage_refused("--tier midiump", "--tier midiump: expected lowp, mediump or highp; did you mean mediump?");
    expect_usage_refused("--shading gourad", "--shading gourad: expected flat, gouraud or phong; did you mean gouraud?");
    expect_usage_refused("--engine fixd", "--engine fixd: expected fixed or reference; did you mean fixed?");
    for (const char* angle : {"181", "-1", "sharp", "30x", "nan"})
        expect_usage_refused(std::string("--crease ") + angle, std::string("--crease ") + angle + ": expected an angle from 0 to 180 degrees, such as 60.");
    expect_usage_refused("--component spekular", "--component spekular: expected all, ambient, diffuse or specular; did you mean specular?");
    expect_usage_refused("--normals sperical", "--normals sperical: expected linear or spherical; did you mean spherical?");
    expect_usage_refused("--reflection phonk", "--reflection phonk: expected blinn_phong or phong; did you mean phong?");
    expect_usage_refused("--light-table big", "--light-table big: expected none, nearest or bilinear.");
    expect_usage_refused("--filter bilinea", "--filter bilinea: expected nearest or bilinear; did you mean bilinear?");
    expect_usage_refused("--mapping flat", "--mapping flat: expected affine or perspective.");
    expect_usage_refused("--shading toon", "--shading toon: expected flat, gouraud or phong.");
    expect_usage_refused("--engine gl", "--engine gl: expected fixed or reference.");
    expect_usage_refused("--szie 1x1", "--szie: there is no such option; did you mean --size?");
    expect_usage_refused("--xyz", "--xyz: there is no such option; see 'shade16 render --help'.");
    expect_usage_refused("more.obj", "more.obj: is one word too many; expected one model");
    expect_usage_refused("--tier", "--tier: expected a value after it");
    expect_usage_refused("--quiet=1", "--quiet: takes no value");
}

TEST(CliRefusal, commands_nobody_knows) {
    expect_refusal(shade16_program(""), 2, "a command is missing: expected render, compare, bake, info, preview, show, materials, gallery or report");
    expect_refusal(shade16_program("rendr"), 2, "rendr: there is no such command; did you mean render?");
    expect_refusal(shade16_program("paint x"), 2, "paint: there is no such command; expected render, compare, bake, info, preview, show, materials, gallery or report");
    expect_refusal(shade16_program("--xyz"), 2, "--xyz: there is no such option; see 'shade16 --help'.");
    expect_refusal(shade16_program("--quiet render"), 2, "--quiet: belongs after the command");
}

TEST(CliRefusal, incomplete_commands) {
    expect_refusal(shade16_program("render"), 2, "the name of the scene is missing: expected SCENE.toml or MODEL.obj");
    expect_refusal(shade16_program("render " + teapot()), 2, "the name of the output is missing: expected -o");
    expect_refusal(shade16_program("bake " + teapot() + " -o"), 2, "--output: expected a value after it");
    expect_refusal(shade16_program("render " + teapot() + " -o ''"), 2, "--output: the name is empty");
}

TEST(CliRefusal, outputs_of_no_known_kind) {
    const ScratchDirectory scratch;
    expect_refusal(shade16_program("render " + teapot() + " -o " + scratch.path("a.gif")), 2,
                   "the ending '.gif' names no known format; expected .y4m, .apng, .png or a raw one (.rgb565, .gray8, .gray4, .mono1)");
    expect_refusal(shade16_program("render " + teapot() + " --format rgb888 -o " + scratch.path("a.rgb565")), 2,
                   ".rgb565 holds 16 bits a pixel, but --format rgb888 has 24");
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(CliRefusal, a_header_over_its_scene_file_or_one_of_its_models) {
    const ScratchDirectory scratch;
    const std::string text = "[meshes.m]\nfile = \"m.obj\"\n[[objects]]\nmesh = \"m\"\n";
    const std::string scene = scratch.write("s.toml", text), model = scratch.write("m.obj", triangle);
    const std::string bake = "bake " + scene + " -o ";
    expect_refusal(shade16_program(bake + scene), 2, "s.toml: is the scene file itself; expected another name");
    expect_refusal(shade16_program(bake + model), 2, "m.obj: is a model of the scene; expected another name");
    expect_refusal(shade16_program(bake + "''"), 2, "--output: the name is empty");
    expect_refusal(shade16_program(bake + scratch.path("no/a.hpp")), 3, "no/a.hpp");
    expect_refusal(shade16_program(bake + scratch.path("a.hpp") + " --name 3d"), 2, "--name 3d: is no C++ name");
    EXPECT_EQ(scratch.read("s.toml"), text);
    EXPECT_EQ(scratch.read("m.obj"), triangle);
    EXPECT_THAT(scratch.names(), ElementsAre("m.obj", "s.toml"));
}

TEST(CliRefusal, a_scene_that_cannot_be_baked) {
    const ScratchDirectory scratch;
    const std::string to = " -o " + scratch.path("a.hpp");
    expect_refusal(shade16_program("bake " + scratch.path("no.toml") + to), 2, "no.toml: cannot be opened");
    const std::string mistake = scratch.write("s.toml", "[meshes.m]\nshape = \"cube\"\n[[objects]]\nmesh = \"n\"\n");
    expect_refusal(shade16_program("bake " + mistake + to), 2, "s.toml:3: object 1 wants the mesh 'n'");
    EXPECT_THAT(scratch.names(), ElementsAre("s.toml"));
}

TEST(CliRefusal, a_header_over_its_model_or_with_no_name) {
    const ScratchDirectory scratch;
    const std::string model = scratch.write("m.obj", triangle);
    expect_refusal(shade16_program("bake " + model + " -o " + model), 2, "m.obj: is the model itself");
    expect_refusal(shade16_program("bake " + model + " --name 3d -o " + scratch.path("a.hpp")), 2,
                   "--name 3d: is no C++ name; expected one such as");
    EXPECT_EQ(scratch.read("m.obj"), triangle);
    EXPECT_THAT(scratch.names(), ElementsAre("m.obj"));
}

}  // namespace
}  // namespace shade16::host
