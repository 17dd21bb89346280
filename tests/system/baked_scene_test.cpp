// From a scene file to flash: the frames of the scene that is loaded at run time are those of the scene that was baked
// and compiled. tests/system/same_on_board.cmake holds the compiled program against the boards.
#include <gmock/gmock.h>

#include "host_sim/model/identifier.hpp"
#include "host_sim/scene_file/bake_scene.hpp"
#include "tests/requirements.hpp"
#include "tests/system/loaded_frames.hpp"
#include "tests/system/program.hpp"
#include "tests/system/scene_file_text.hpp"

namespace shade16::host {
namespace {

using testing::HasSubstr;
using testing::Not;

LoadedScene loaded(const std::string& text) { return LoadedScene(read_scene_text(text, "scene.toml")); }

std::string header_of(const std::string& text) { return bake_scene_header(loaded(text), "shown"); }

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(BakedScene, every_scene_file_of_the_project_is_drawn_alike_loaded_and_compiled) {
    ASSERT_GE(scene_files().size(), 11u);
    for (const std::string& path : scene_files()) {
        SCOPED_TRACE(path);
        const std::filesystem::path program =
            std::filesystem::path(SHADE16_SCENE_PROGRAMS) / ("scene_" + std::filesystem::path(path).stem().string());
        ASSERT_TRUE(std::filesystem::exists(program)) << "bake it: every scene file has a header beside it";
        EXPECT_EQ(run_shell("'" + program.string() + "'").out, loaded_frames(LoadedScene(read_scene(path))));
    }
}

// What the scenes of the project do not have: other formats and tiers, an orthographic camera, light and object without
// any key, a shape too large for the compiler, names that C++ does not have.
const std::string orthographic = R"([output]
size = [61, 47]
format = "rgb888"
tier = "lowp"
[camera]
eye = [0.5, 1.5, 4]
projection = "orthographic"
viewer = "local"
view_height = 3.3
[[lights]]
[[lights]]
kind = "point"
space = "view"
position = [0.3, 1, -1]
specular = [0.3, 0.6, 1]
[materials."Pixel"]
specular = [1, 1, 1]
shininess = 1000
[materials."double"]
ambient = [0, 0, 0]
shading = "flat"
[meshes.frames]
shape = "sphere"
slices = 64
stacks = 48
[meshes."a-b"]
shape = "torus"
[meshes."a b"]
shape = "cube"
[meshes."9"]
shape = "quad"
colors = ["#FF0000", "#00FF00", "#0000FF", "#FFFFFF"]
[[objects]]
mesh = "frames"
material = "Pixel"
[[objects]]
mesh = "a-b"
material = "double"
scale = [1.1, 0.9, 1]
rotation = [10, 20, 30]
[[objects]]
mesh = "a b"
translation = [1, 1, -1]
spin = { turns = 0.25, axis = "x" }
[[objects]]
mesh = "9"
scale = 0.5
translation = [-1, -1, 1]
)";

const std::string alone = R"([output]
size = [40, 30]
format = "rgb565_swapped"
tier = "highp"
[[lights]]
direction = [1, 2, 3]
[meshes.cube]
shape = "cube"
[[objects]]
mesh = "cube"
material = "gold"
rotation = [20, 30, 0]
scale = 0.7
)";

const std::string unlit_in_the_dark =
    "[output]\nsize = [40, 30]\n[meshes.q]\nshape = \"quad\"\n[materials.m]\nunlit = true\ndiffuse = [0.1, 0.7, "
    "0.3]\n[[objects]]\nmesh = \"q\"\nmaterial = \"m\"\ncentred = true\nspin = { turns = 1 }\n";

class BakedSceneCompiles : public testing::TestWithParam<std::tuple<const char*, std::string>> {};

TEST_P(BakedSceneCompiles, and_draws_the_same_frames) {
    const auto& [compiler, text] = GetParam();
    if (!has_program(compiler)) GTEST_SKIP() << compiler << " is not installed.";
    const ScratchDirectory scratch;
    const std::string file = scratch.write("shown.toml", text), root = source_directory().string();
    ASSERT_EQ(shade16_program("bake '" + file + "' --quiet -o '" + scratch.path("shown.hpp") + "'").exit_code, 0);
    const Ran ran =
        run_shell("cd '" + scratch.path("") + "' && " + compiler +
                  " -std=c++20 -O1 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion "
                  "-Wdouble-promotion -Werror -DSHADE16_SCENE=shown '-DSHADE16_SCENE_HEADER=\"shown.hpp\"' "
                  "-I . -I '" +
                  root + "/core/include' -I '" + root + "/firmware' -o shown '" + root + "'/firmware/apps/scene.cpp '" +
                  root + "'/firmware/runtime/console.cpp '" + root + "'/firmware/runtime/console_host.cpp && ./shown");
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(ran.out, loaded_frames(LoadedScene(read_scene(file))));
}

INSTANTIATE_TEST_SUITE_P(, BakedSceneCompiles,
                         testing::Combine(testing::Values("g++", "clang++"),
                                          testing::Values(orthographic, alone, unlit_in_the_dark)),
                         [](const auto& test) { return "number_" + std::to_string(test.index); });

TEST(BakedScene, a_mesh_that_objects_share_is_written_once) {
    const std::string twice = header_of(
        "[meshes.q]\nshape = \"quad\"\ncolors = [\"#FF0000\", \"#00FF00\", \"#0000FF\", \"#FFFFFF\"]\n"
        "[[objects]]\nmesh = \"q\"\n[[objects]]\nmesh = \"q\"\nconvex = false\n[[objects]]\nmesh = \"q\"\n");
    EXPECT_EQ(count(twice, "shade16::Position16 "), 1u);
    EXPECT_EQ(count(twice, "Mesh q{"), 1u);
    EXPECT_EQ(count(twice, "Mesh q_not_convex{"), 1u);
    EXPECT_EQ(count(twice, "{.mesh = q, "), 2u);
    EXPECT_THAT(twice, HasSubstr("// 4 vertices, 2 triangles, 84 bytes of flash."));
}

TEST(BakedScene, a_mesh_that_no_object_draws_is_left_out) {
    EXPECT_THAT(header_of(one_ball + "[meshes.unused]\nshape = \"cube\"\n"), Not(HasSubstr("unused")));
}

TEST(BakedScene, a_shape_is_left_to_the_compiler_where_it_can_make_it) {
    const auto shape = [](const std::string& keys) {
        return header_of("[meshes.m]\n" + keys + "[[objects]]\nmesh = \"m\"\n");
    };
    EXPECT_THAT(shape("shape = \"cube\"\n"), HasSubstr("shade16::Mesh m = shade16::cube.mesh();"));
    EXPECT_THAT(shape("shape = \"quad\"\n"), HasSubstr("shade16::Mesh m = shade16::quad.mesh();"));
    EXPECT_THAT(shape("shape = \"sphere\"\n"), HasSubstr("= shade16::sphere<32, 16>.mesh();"));
    EXPECT_THAT(shape("shape = \"torus\"\n"), HasSubstr("= shade16::torus<48, 24>.mesh();"));
    EXPECT_THAT(shape("shape = \"torus\"\nminor_radius = 0.5\n"), HasSubstr("shade16::torus<48, 24, 536870912>"));
    EXPECT_THAT(shape("shape = \"sphere\"\nslices = 64\nstacks = 33\n"), HasSubstr("m_positions[] = {"));
}

TEST(BakedScene, what_is_at_its_default_is_left_out_and_the_rest_is_explained) {
    const std::string plain = header_of(one_ball);
    EXPECT_THAT(plain, HasSubstr("inline constexpr shade16::Scene scene{\n    .objects = objects,\n};\n"));
    EXPECT_THAT(plain, HasSubstr("inline constexpr shade16::Material ball_material{};\n"));
    EXPECT_THAT(plain, HasSubstr("Spin spins[] = {\n    {},\n};\n"));
    EXPECT_THAT(plain, Not(HasSubstr("lights")));
    EXPECT_THAT(plain, HasSubstr("inline constexpr uint32_t frames = 1;\n"));

    const std::string more = header_of("[camera]\nfov = 60\neye = [0, 1.5, 3]\n[[lights]]\nintensity = 0.7\n" +
                                       one_ball + "rotation = [0, 30, 0]\nspin = { turns = 1 }\n");
    EXPECT_THAT(more, HasSubstr(".fov_y = {715827883u},  // 60 degrees\n"));
    EXPECT_THAT(more, HasSubstr(".eye = {0, shade16::Q16::from_raw(98304), 3},  // 0, 1.5, 3\n"));
    EXPECT_THAT(more, HasSubstr(".intensity = {3006477056u, 0},  // 0.7\n"));
    EXPECT_THAT(more, HasSubstr("// 0, 30, 0 degrees about x, y, z; order xyz\n"));
    EXPECT_THAT(more, HasSubstr("inline constexpr uint32_t frames = 90;\n"));
}

TEST(BakedScene, its_header_has_no_long_line_and_no_path_and_is_the_same_each_time) {
    for (const std::string& path : scene_files()) {
        const std::string text = bake_scene_header(LoadedScene(read_scene(path)), "x");
        EXPECT_EQ(text, bake_scene_header(LoadedScene(read_scene(path)), "x"));
        EXPECT_THAT(text, Not(HasSubstr(source_directory().string())));
        for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
            end = text.find('\n', at);
            ASSERT_LE(end - at, 120u) << text.substr(at, end - at);
        }
    }
    EXPECT_THAT(bake_scene_header(loaded(one_ball), "shade16"), HasSubstr("namespace assets::shade16_ {"));
}

}  // namespace
}  // namespace shade16::host
