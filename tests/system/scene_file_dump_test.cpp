// A scene that was dumped is read again to the same bits; every scene file of the project, and a fitted model.
#include <regex>

#include <gmock/gmock.h>

#include "host_sim/scene_file/describe_model.hpp"
#include "tests/system/program.hpp"
#include "tests/system/scene_file_text.hpp"

namespace shade16::host {
namespace {

void expect_round_trip(const LoadedScene& scene) {
    const std::string text = dump_scene(scene.description());
    const ScratchDirectory elsewhere;
    const LoadedScene again(read_scene(elsewhere.write("again.toml", text)));
    expect_same(scene.scene(), again.scene());
    for (const Angle elapsed : {Angle{}, 0.3_turn, 0.5_turn}) EXPECT_EQ(scene.poses(elapsed), again.poses(elapsed));
    EXPECT_EQ(dump_scene(again.description()), text);
}

TEST(SceneFileDump, every_scene_of_the_project) {
    ASSERT_GE(scene_files().size(), 10u);
    for (const std::string& path : scene_files()) {
        SCOPED_TRACE(path);
        expect_round_trip(LoadedScene(read_scene(path)));
    }
}

TEST(SceneFileDump, every_kind_of_key) {
    const std::string text = R"(background = "#010203"
[output]
size = [33, 44]
format = "rgb888"
tier = "highp"
frames = 7
fps = 12
bands = 5
[camera]
eye = [0.1, 0.2, 9.3]
up = [0, -1, 0.1]
projection = "orthographic"
viewer = "local"
fov = 33.333333
view_height = 3.3
near = 0.01
far = 1000.7
[[lights]]
kind = "point"
space = "object"
diffuse = [0.1, 0.3, 0.7]
specular = "#00FF00"
intensity = 12.345678
attenuation = { constant = 0, linear = 0.3, quadratic = 0.017 }
[[lights]]
kind = "spot"
space = "view"
position = [0.3, 1.7, -2]
direction = [0.1, -1, 0.2]
inner = 7.7
outer = 33.333333
exponent = 5.3
range = 12.1
attenuation = { constant = 0.9, power = 1.3 }
[materials."a \"b\""]
reflection = "phong"
ambient = [0.1, 0.2, 0.3]
emissive = [0.01, 0.02, 0.03]
shading = "flat"
shininess = 3.3
[meshes.q]
shape = "quad"
colors = ["#FF0000", [0.1, 0.5, 0.9], "#0000FF", "#ffffff"]
[meshes.t]
shape = "torus"
minor_radius = 0.123456
[[objects]]
mesh = "q"
material = "a \"b\""
rotation = [-10.1, 0.3, 725]
order = "zyx"
convex = false
[[objects]]
mesh = "t"
material = "gold"
scale = [0.3, 1.7, 0.01]
translation = [-1.1, 0, 3]
spin = { turns = -0.3, axis = "z" }
centred = true
)";
    expect_round_trip(LoadedScene(read_scene_text(text, "scene.toml")));
}

TEST(SceneFileDump, the_documented_example) {
    const ScratchDirectory scratch;
    std::ifstream file(source_directory() / "docs/scene-file.md");
    const std::string document{std::istreambuf_iterator<char>(file), {}};
    const std::size_t begin = document.find("```toml\n"), end = document.find("```\n", begin + 8);
    ASSERT_NE(end, std::string::npos);
    expect_round_trip(
        LoadedScene(read_scene(scratch.write("scene.toml", document.substr(begin + 8, end - begin - 8)))));
}

TEST(SceneFileDump, a_fitted_model_draws_the_same_frames) {
    const ScratchDirectory scratch;
    const std::string dump = scratch.path("scene.toml"), size = " --size 64x48 --frames 3 --quiet -o ";
    EXPECT_EQ(run_shell("\"$shade16\" render " + teapot() + " --size 64x48 --dump-scene >" + dump).exit_code, 0);
    EXPECT_EQ(shade16_program("render " + teapot() + size + scratch.path("a.y4m")).exit_code, 0);
    EXPECT_EQ(shade16_program("render " + dump + size + scratch.path("b.y4m")).exit_code, 0);
    EXPECT_FALSE(scratch.read("a.y4m").empty());
    EXPECT_EQ(scratch.read("a.y4m"), scratch.read("b.y4m"));
}

}  // namespace
}  // namespace shade16::host
