// A scene file's numbers are the core's integers, and what it leaves out is the core's default.
#include <gmock/gmock.h>

#include "host_sim/scene_file/decimal.hpp"
#include "host_sim/scene_file/describe_model.hpp"
#include "tests/system/imported.hpp"
#include "tests/system/scene_file_text.hpp"

namespace shade16::host {
namespace {

LoadedScene loaded(const std::string& text) { return LoadedScene(read_scene_text(text, "scene.toml")); }

TEST(SceneFileValues, decimals_are_the_literals) {
    EXPECT_EQ(q16_of(0.1), 0.1_q16);
    EXPECT_EQ(q16_of(-1.7), -1.7_q16);
    EXPECT_EQ(q16_of(27.89743616), 27.89743616_q16);
    EXPECT_EQ(q16_of(16383.999999999), 16383.999999999_q16);
    EXPECT_EQ(q16_of(0.000007629), 0.000007629_q16);
    EXPECT_EQ(q16_of(0.00000763), 0.00000763_q16);
    EXPECT_EQ(unorm_of(0.1), 0.1_unorm);  // a tie: 6553.5
    EXPECT_EQ(unorm_of(0.3), 0.3_unorm);
    EXPECT_EQ(unorm_of(0.5), 0.5_unorm);
    EXPECT_EQ(unorm_of(0.7), 0.7_unorm);
    EXPECT_EQ(unorm_of(0.9), 0.9_unorm);
    EXPECT_EQ(unorm_of(0.780392), 0.780392_unorm);
    EXPECT_EQ(scaled_of(0.7), 0.7_scaled);
    EXPECT_EQ(scaled_of(10000.0001), 10000.0001_scaled);
    EXPECT_EQ(degrees_of(36), 36_deg);
    EXPECT_EQ(degrees_of(22.123456789), 22.123456789_deg);
    EXPECT_EQ(degrees_of(-30), -30_deg);
    EXPECT_EQ(degrees_of(390), 30_deg);
}

TEST(SceneFileValues, every_value_has_a_decimal_that_reads_back) {
    for (uint32_t raw = 0; raw <= 65535; ++raw) {
        ASSERT_EQ(unorm_of(std::stod(decimal(Unorm16::from_raw(raw)))), Unorm16::from_raw(raw));
        const Q16 q = Q16::from_raw(static_cast<int32_t>(raw * 40503u));
        ASSERT_EQ(q16_of(std::stod(decimal(q))), q);
    }
    for (const char* text : {"0.001", "36", "45.5", "123.456789123", "179.999"})
        EXPECT_EQ(degrees_of(std::stod(decimal_degrees(degrees_of(std::stod(text))))), degrees_of(std::stod(text)));
}

TEST(SceneFileValues, defaults_are_the_cores) {
    const LoadedScene scene = loaded(one_ball);
    EXPECT_TRUE(same(scene.scene().camera, Camera{}));
    EXPECT_EQ(scene.scene().background, Scene{}.background);
    EXPECT_EQ(scene.scene().lights.count, 0u);
    EXPECT_EQ(scene.scene().objects[0].material, Material{});
    EXPECT_EQ(scene.scene().objects[0].pose, Pose{});
    const LoadedScene lit =
        loaded("[[lights]]\n[[lights]]\nkind = \"ambient\"\n[[lights]]\nkind = \"point\"\n[materials.m]\n[camera]\n" +
               one_ball + "material = \"m\"\n");
    EXPECT_TRUE(same(lit.scene().lights[0], Light{}));
    EXPECT_TRUE(same(lit.scene().lights[1], ambient_light(white)));
    EXPECT_TRUE(same(lit.scene().lights[2], Light{.kind = LightKind::point}));
    EXPECT_EQ(lit.scene().objects[0].material, Material{});
    EXPECT_TRUE(same(lit.scene().camera, Camera{}));
    const LoadedScene spot = loaded("[[lights]]\nkind = \"spot\"\n" + one_ball);
    EXPECT_TRUE(same(spot.scene().lights[0], Light{.kind = LightKind::spot}));
}

TEST(SceneFileValues, of_a_spot) {
    const LoadedScene scene = loaded(
        "[[lights]]\nkind = \"spot\"\nposition = [1, 2, 3]\ndirection = [0, -1, 0.5]\ninner = 12.5\nouter = 30\n"
        "exponent = 3\nrange = 9.5\nattenuation = { power = 0.7 }\n[materials.m]\nreflection = \"phong\"\n" +
        one_ball + "material = \"m\"\n");
    const Light expected{.kind = LightKind::spot,
                         .position = {1, 2, 3},
                         .attenuation = {.power = 0.7_q16},
                         .range = 9.5_q16,
                         .spot = {{0, -1, 0.5_q16}, 12.5_deg, 30_deg, 3}};
    EXPECT_TRUE(same(scene.scene().lights[0], expected));
    EXPECT_EQ(scene.scene().objects[0].material.reflection, Reflection::phong);
}

TEST(SceneFileValues, shapes_are_the_compilers) {
    const auto mesh = [](const std::string& keys) {
        return LoadedScene(read_scene_text("[meshes.m]\n" + keys + "\n[[objects]]\nmesh = \"m\"\n", "s.toml"));
    };
    EXPECT_TRUE(
        same(mesh("shape = \"sphere\"\nslices = 24\nstacks = 12").scene().objects[0].mesh, sphere<24, 12>.mesh()));
    EXPECT_TRUE(same(mesh("shape = \"torus\"\nrings = 24\nsides = 12").scene().objects[0].mesh, torus<24, 12>.mesh()));
    EXPECT_TRUE(same(mesh("shape = \"torus\"\nrings = 9\nsides = 8\nminor_radius = 0.25").scene().objects[0].mesh,
                     torus<9, 8, (1 << 28)>.mesh()));
    EXPECT_TRUE(same(mesh("shape = \"cube\"").scene().objects[0].mesh, cube.mesh()));
    EXPECT_TRUE(same(mesh("shape = \"quad\"").scene().objects[0].mesh, quad.mesh()));
}

TEST(SceneFileValues, poses_turn_in_the_stated_order) {
    const LoadedScene scene = loaded(one_ball +
                                     "rotation = [10, 20, 30]\norder = \"zxy\"\nscale = [1, 2, 3]\ntranslation = [1, "
                                     "-2, 0.5]\nspin = { turns = 0.5 }\n");
    const Mat3 rotation = rotate_y(20_deg) * (rotate_x(10_deg) * rotate_z(30_deg));
    EXPECT_EQ(scene.scene().objects[0].pose, (Pose{rotation, {1, 2, 3}, {1, -2, 0.5_q16}}));
    EXPECT_EQ(scene.poses(180_deg)[0].rotation, rotate_y(90_deg) * rotation);
}

TEST(SceneFileValues, materials_are_like_others) {
    const LoadedScene scene = loaded(
        "[materials.brass]\nlike = \"brass\"\nshininess = 60\n[materials.dull]\nlike = \"brass\"\nspecular = "
        "\"#000000\"\n" +
        one_ball + "material = \"dull\"\n");
    Material expected = *find_material("brass");
    expected.shininess = 60;
    expected.specular = black;
    EXPECT_EQ(scene.scene().objects[0].material, expected);
}

TEST(SceneFileValues, an_open_mesh_may_be_called_convex_where_it_is) {
    const auto text = [](const char* file) {
        return read_scene_text(
            std::string("[meshes.m]\nfile = \"") + file + "\"\n[[objects]]\nmesh = \"m\"\nconvex = true\n",
            (source_directory() / "assets/scenes/x.toml").string());
    };
    EXPECT_FALSE(needs_of(LoadedScene(text("quad.obj")).scene()).depth);
    EXPECT_THAT(complaint([&] { LoadedScene scene(text("torus64x32.obj")); }),
                testing::HasSubstr("x.toml:3: object 1 says convex = true"));
}

}  // namespace
}  // namespace shade16::host
