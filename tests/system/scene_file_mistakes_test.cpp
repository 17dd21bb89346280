// What is no scene: each kind of mistake, with the sentence that it gets, its file and its line.
#include <gmock/gmock.h>

#include "tests/system/program.hpp"
#include "tests/system/scene_file_text.hpp"

namespace shade16::host {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;

/// `text` gets this very sentence, after "scene.toml:".
void expect_wrong(const std::string& text, const std::string& sentence) {
    EXPECT_EQ(complaint([&] { LoadedScene scene(read_scene_text(text, "scene.toml")); }), "2: scene.toml:" + sentence);
}

/// `key` as the fifth line of a scene with one object, below `heading`.
void expect_wrong_key(const std::string& heading, const std::string& key, const std::string& sentence) {
    expect_wrong("[meshes.ball]\nshape = \"sphere\"\n" + heading + "\n" + key + "\n[[objects]]\nmesh = \"ball\"\n",
                 "4: " + sentence);
}

TEST(SceneFileMistakes, a_typing_error_is_told_the_nearest_key) {
    expect_wrong_key("[materials.brass]", "shinines = 3",
                     "unknown key 'shinines' in material 'brass'; did you mean 'shininess'?");
    expect_wrong_key("[camera]", "fow = 3", "unknown key 'fow' in the camera; did you mean 'fov'?");
    expect_wrong_key("[output]", "sice = [1, 2]", "unknown key 'sice' in the output; did you mean 'size'?");
    expect_wrong_key("[[lights]]", "intensty = 1", "unknown key 'intensty' in light 1; did you mean 'intensity'?");
    expect_wrong("bckground = \"#000000\"\n" + one_ball,
                 "1: unknown key 'bckground' in the scene; did you mean 'background'?");
    expect_wrong(one_ball + "rotatoin = [0, 0, 0]\n",
                 "5: unknown key 'rotatoin' in object 1; did you mean 'rotation'?");
    expect_wrong(one_ball + "spin = { turn = 1 }\n",
                 "5: unknown key 'turn' in the spin of object 1; did you mean 'turns'?");
    expect_wrong_key("[camera]", "whatever = 1",
                     "unknown key 'whatever' in the camera; expected one of eye, target, up, projection, viewer, fov, "
                     "view_height, near, far.");
}

TEST(SceneFileMistakes, keys_of_another_kind_of_thing) {
    expect_wrong_key("[[lights]]", "position = [1, 2, 3]",
                     "unknown key 'position' in light 1 (directional); expected one of kind, color, diffuse, specular, "
                     "intensity, space, direction.");
    expect_wrong("[meshes.m]\nshape = \"cube\"\nslices = 8\n",
                 "3: unknown key 'slices' in mesh 'm'; expected one of shape, colors.");
}

TEST(SceneFileMistakes, lamps_that_can_not_be) {
    const auto spot = [](const std::string& key, const std::string& sentence) {
        expect_wrong("[meshes.ball]\nshape = \"sphere\"\n[[lights]]\nkind = \"spot\"\n" + key + "\n[[objects]]\nmesh = \"ball\"\n", "5: " + sentence);
    };
    spot("inner = 50", "'inner' in light 1 (spot) is 50; expected at most outer, which is 45.");
    spot("outer = 91", "'outer' in light 1 (spot) is 91; expected a number from 0 to 90.");
    spot("exponent = 200", "'exponent' in light 1 (spot) is 200; expected a number from 0 to 128.");
    spot("direction = [0, 0, 0]", "'direction' in light 1 (spot) has no length; expected where the spot shines to, such as [0, -1, 0].");
    spot("range = -1", "'range' in light 1 (spot) is -1; expected a number from 0 to 16384.");
    spot("attenuation = { power = 2.5 }", "'power' in the attenuation of light 1 is 2.5; expected a number from 0 to 2.");
    expect_wrong_key("[[lights]]", "kind = \"spotlight\"",
                     "'kind' in light 1 is \"spotlight\"; expected \"ambient\", \"directional\", \"point\" or \"spot\".");
    expect_wrong_key("[materials.m]", "reflection = \"fong\"",
                     "'reflection' in material 'm' is \"fong\"; expected \"blinn_phong\" or \"phong\".");
}

TEST(SceneFileMistakes, no_toml) {
    const auto complaint_of = [](const char* text) { return complaint([&] { read_scene_text(text, "scene.toml"); }); };
    EXPECT_THAT(complaint_of("a = = 1\n"), testing::StartsWith("2: scene.toml:1: is not valid TOML: "));
    EXPECT_THAT(complaint_of("[camera]\nnear = 1\nnear = 2\n"),
                testing::StartsWith("2: scene.toml:3: is not valid TOML: "));
    EXPECT_THAT(complaint_of("\n[camera\n"), testing::StartsWith("2: scene.toml:2: is not valid TOML: "));
}

/// They are tables one inside the other, of which a hundred thousand are more than a stack holds.
TEST(SceneFileMistakes, names_of_many_parts) {
    const std::string expected = " has a name of more than 8 parts; expected one such as materials.wall.diffuse.";
    const std::string eight = "a.a.a.a.a.a.a.a", nine = eight + ".a";
    expect_wrong(eight + " = 1\n", "1: unknown key 'a' in the scene; expected one of output, camera, background, lights, materials, meshes, objects.");
    for (const std::string& text : {nine + " = 1\n", "[" + nine + "]\n", "x = {" + nine + " = 1}\n", std::string("a . 'b' . \"c\\\"\".d.e.f.g.h.i = 1\n")})
        expect_wrong(text, "1:" + expected);
    expect_wrong("[camera]\n# a.a.a\n" + nine + " = 1\n", "3:" + expected);
    for (const char* harmless : {"# a.a.a.a.a.a.a.a.a.a.a", "x = \"a.a.a.a.a.a.a.a.a.a\"", "x = 'a.a.a.a.a.a.a.a.a.a'", "x = \"\"\"\n\"a.a.a.a.a.a.a.a.a.a\"\"\"",
                                 "x = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]"})
        EXPECT_EQ(complaint([&] { read_scene_text(one_ball + harmless, "scene.toml"); }).find(expected), std::string::npos) << harmless;
    for (const char* string : {"x = '''a''''\n", "x = \"\"\"a\"\"\"\"\"\n"}) expect_wrong(string + nine + " = 1\n", "2:" + expected);
    std::string deep = "a";
    for (int i = 0; i < 200'000; ++i) deep += ".a";
    expect_wrong(deep + " = 1\n", "1:" + expected);
}

TEST(SceneFileMistakes, wrong_types) {
    expect_wrong_key("[camera]", "fov = \"wide\"",
                     "'fov' in the camera is a text; expected a number from 0.001 to 179.999.");
    expect_wrong_key("[camera]", "fov = 1979-05-27",
                     "'fov' in the camera is a date; expected a number from 0.001 to 179.999.");
    expect_wrong_key("[camera]", "eye = 3",
                     "'eye' in the camera is a whole number; expected three numbers such as [0, 1.5, -2].");
    expect_wrong_key("[camera]", "eye = [1, 2]",
                     "'eye' in the camera has 2 elements; expected three numbers such as [0, 1.5, -2].");
    expect_wrong_key("[camera]", "eye = [1, 2, true]",
                     "'eye' in the camera is true or false; expected a number from -16384 to 16384.");
    expect_wrong_key("[output]", "frames = 1.5",
                     "'frames' in the output is a number with decimals; expected a whole number from 1 to 100000.");
    expect_wrong_key("[output]", "tier = 1", "'tier' in the output is a whole number; expected a text.");
    expect_wrong_key("[materials.m]", "unlit = 1",
                     "'unlit' in material 'm' is a whole number; expected true or false.");
    expect_wrong("camera = 3\n" + one_ball, "1: the camera is a whole number; expected a table.");
    expect_wrong("[lights]\n" + one_ball,
                 "1: 'lights' in the scene is a table; expected a list of tables, each below its own [[lights]].");
    expect_wrong("meshes = 1\n",
                 "1: 'meshes' in the scene is a whole number; expected tables with names, such as [meshes.wall].");
}

TEST(SceneFileMistakes, colors) {
    const std::string expected = "expected [r, g, b], each from 0 to 1, or a text such as \"#FF8855\".";
    expect_wrong_key("[materials.m]", "diffuse = \"red\"", "'diffuse' in material 'm' is \"red\"; " + expected);
    expect_wrong_key("[materials.m]", "diffuse = \"#12345g\"", "'diffuse' in material 'm' is \"#12345g\"; " + expected);
    expect_wrong_key("[materials.m]", "diffuse = [1, 1]", "'diffuse' in material 'm' has 2 elements; " + expected);
    expect_wrong_key("[materials.m]", "diffuse = 1", "'diffuse' in material 'm' is a whole number; " + expected);
    expect_wrong_key("[materials.m]", "diffuse = [255, 0, 0]",
                     "'diffuse' in material 'm' is 255; expected a number from 0 to 1.");
}

TEST(SceneFileMistakes, out_of_range) {
    expect_wrong_key("[camera]", "fov = 180", "'fov' in the camera is 180; expected a number from 0.001 to 179.999.");
    expect_wrong_key("[camera]", "near = nan", "'near' in the camera is nan; expected a number from 0.001 to 16384.");
    expect_wrong_key("[camera]", "near = -inf", "'near' in the camera is -inf; expected a number from 0.001 to 16384.");
    expect_wrong_key("[camera]", "far = 0.5", "'far' in the camera is 0.5; expected more than near, which is 1.");
    expect_wrong_key("[camera]", "target = [0, 0, 3]",
                     "'target' in the camera is where the eye is; expected another point.");
    expect_wrong_key("[camera]", "up = [0, 0, 0]",
                     "'up' in the camera has no length; expected a direction such as [0, 1, 0].");
    expect_wrong_key("[materials.m]", "shininess = 1001",
                     "'shininess' in material 'm' is 1001; expected a number from 1 to 1000.");
    expect_wrong_key("[output]", "size = [0, 240]",
                     "'size' in the output is out of range; expected [width, height], whole numbers from 1 to 2048.");
    expect_wrong_key(
        "[output]", "tier = \"medium\"",
        "'tier' in the output is \"medium\"; expected \"lowp\", \"mediump\" or \"highp\" (did you mean \"mediump\"?).");
    expect_wrong_key("[[lights]]", "direction = [0, 0, 0]",
                     "'direction' in light 1 (directional) has no length; expected the direction towards the light, "
                     "such as [1, 2, 3].");
    expect_wrong(one_ball + "scale = 0\n", "5: 'scale' in object 1 is 0; expected a number from 0.0001 to 16384.");
    expect_wrong("[meshes.m]\nshape = \"sphere\"\nslices = 2\n",
                 "3: 'slices' in mesh 'm' is 2; expected a whole number from 3 to 2000.");
    expect_wrong("[meshes.m]\nshape = \"torus\"\nminor_radius = 1\n",
                 "3: 'minor_radius' in mesh 'm' is 1; expected a number above 0 and below 1.");
    expect_wrong("[meshes.m]\nshape = \"sphere\"\nslices = 2000\nstacks = 2000\n",
                 "3: 'slices' in mesh 'm' times 'stacks' is 4000000; expected at most 65535 vertices.");
    expect_wrong("[meshes.m]\nshape = \"quad\"\ncolors = [\"#000000\"]\n[[objects]]\nmesh = \"m\"\n",
                 "1: mesh 'm': 'colors' has 1 elements; expected 4, one a vertex.");
    expect_wrong(one_ball + "scale = 10000\ntranslation = [0, 16000, 0]\n",
                 "3: object 1 reaches 26000 units from the origin; expected at most 16384.");
}

TEST(SceneFileMistakes, references) {
    expect_wrong("[meshes.ball]\nshape = \"cube\"\n[[objects]]\nmesh = \"bal\"\n",
                 "3: object 1 wants the mesh 'bal', which is not there; the nearest one is 'ball'.");
    expect_wrong("[[objects]]\nmesh = \"ball\"\n",
                 "1: object 1 wants the mesh 'ball', which is not there; expected one under [meshes].");
    expect_wrong(one_ball + "material = \"bras\"\n",
                 "3: object 1 wants the material 'bras', which is not there; the nearest one is 'brass'.");
    expect_wrong(one_ball + "material = \"mtl\"\n",
                 "3: object 1 wants the material 'mtl', which is not there; a built-in shape has none of its own, so "
                 "expected a name.");
    expect_wrong("[materials.a]\nlike = \"b\"\n[materials.b]\nlike = \"a\"\n" + one_ball,
                 "4: 'like' in material 'b' goes round in a circle: a is like b is like a.");
    expect_wrong("[materials.a]\nlike = \"a\"\n" + one_ball,
                 "2: 'like' in material 'a' goes round in a circle: a is like a.");
    const auto in_a_row = [](int count) {
        std::string text = one_ball;
        for (int i = 1; i < count; ++i) text += fmt::format("[materials.m{}]\nlike = \"m{}\"\n", i, i + 1);
        return text + fmt::format("[materials.m{}]\n", count);
    };
    EXPECT_NO_THROW(read_scene_text(in_a_row(16), "scene.toml"));
    expect_wrong(in_a_row(17), "36: 'like' in material 'm16' is one of more than 16 in a row; expected fewer.");
    expect_wrong("[materials.a]\nlike = \"golt\"\n" + one_ball,
                 "2: 'like' in material 'a' names no material: 'golt'; the nearest one is 'gold'.");
    expect_wrong("[materials.mtl]\n" + one_ball,
                 "1: material 'mtl' is what a model's own materials are called; expected another name.");
}

TEST(SceneFileMistakes, what_is_missing) {
    expect_wrong("", "1: the scene has no 'objects'; expected at least one [[objects]] with a mesh.");
    expect_wrong("[[objects]]\n", "1: object 1 has no 'mesh'; expected the name of a table under [meshes].");
    expect_wrong("[meshes.m]\n",
                 "1: mesh 'm' has no 'file'; expected file = \"model.obj\", or shape = \"sphere\", \"torus\", \"cube\" "
                 "or \"quad\".");
    expect_wrong("[meshes.m]\nfile = \"a.obj\"\nshape = \"cube\"\n",
                 "2: 'file' in mesh 'm' is beside 'shape'; expected one of the two.");
    expect_wrong("[meshes.m]\nfile = \"no/such.obj\"\n[[objects]]\nmesh = \"m\"\n",
                 "1: mesh 'm': no/such.obj: cannot be opened: No such file or directory.");
}

TEST(SceneFileMistakes, the_program_says_so_and_writes_nothing) {
    const ScratchDirectory scratch;
    const std::string scene = scratch.write("scene.toml", one_ball + "mateial = \"gold\"\n");
    const std::string sentence =
        "shade16: " + scene + ":5: unknown key 'mateial' in object 1; did you mean 'material'?\n";
    for (const std::string& arguments :
         {"render " + scene + " -o " + scratch.path("a.png"), "render " + scene + " -o -",
          "render " + scene + " --dump-scene", "compare " + scene}) {
        const Ran ran = shade16_program(arguments);
        EXPECT_EQ(ran.exit_code, 2) << arguments;
        EXPECT_EQ(ran.err, sentence) << arguments;
        EXPECT_THAT(ran.out, IsEmpty()) << arguments;
    }
    EXPECT_EQ(shade16_program("render " + scratch.path("no.toml") + " -o " + scratch.path("a.png")).exit_code, 2);
    EXPECT_THAT(scratch.names(), ElementsAre("scene.toml"));
}

TEST(SceneFileMistakes, the_command_line_wins_over_the_file) {
    const ScratchDirectory scratch;
    const std::string scene =
        scratch.write("scene.toml", "[output]\nsize = [20, 10]\nfps = 7\nframes = 2\n" + one_ball);
    const auto beginning = [&](const std::string& more) {
        return shade16_program("render " + scene + " -o - " + more).out.substr(0, 24);
    };
    EXPECT_THAT(beginning(""), testing::HasSubstr("W20 H10 F7:1"));
    EXPECT_THAT(beginning("--size 30x16 --fps 30"), testing::HasSubstr("W30 H16 F30:1"));
    EXPECT_THAT(shade16_program("render " + scene + " --dump-scene --shading flat").err,
                EndsWith("expected none of it beside it.\n"));
}

}  // namespace
}  // namespace shade16::host
