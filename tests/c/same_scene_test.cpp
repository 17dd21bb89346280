// Many terms at once: a scene of C structs is drawn as the same scene is by the C++ API, from frame to frame.
#include <gtest/gtest.h>

#include "host_sim/engine/runtime_renderer.hpp"
#include "shade16.h"

namespace {
using namespace shade16;

constexpr int32_t width = 64, height = 48;

/// A shape of the engine as a C mesh: its arrays are the same memory.
shade16_mesh as_c(const Mesh& m) {
    return {reinterpret_cast<const shade16_position*>(m.positions.first), reinterpret_cast<const shade16_normal*>(m.normals.first), nullptr,
            reinterpret_cast<const shade16_triangle*>(m.triangles.first), m.positions.count, m.triangles.count, {0, 0, 0}, m.fraction_bits, m.convex};
}

struct BothScenes {
    static constexpr int shapes = 3;
    const Mesh mesh[shapes]{sphere<16, 8>.mesh(), torus<16, 8>.mesh(), cube.mesh()};
    const shade16_mesh c_mesh[shapes]{as_c(mesh[0]), as_c(mesh[1]), as_c(mesh[2])};

    Light lights[4]{ambient_light(rgb(0x303030)), directional_light({1, 2, 3}, rgb(0xFFE0C0), 0.6_scaled), point_light({-3, 2, 2}, rgb(0x80A0FF), 12_scaled),
                    spot_light({0, 4, 2}, {.direction = {0, -4, -2}, .inner = 10_deg, .outer = 30_deg, .exponent = 3}, white, 2_scaled)};
    Object objects[shapes]{{mesh[0], *find_material("brass")}, {mesh[1], *find_material("ruby")}, {mesh[2], *find_material("jade")}};
    Scene scene{.camera = {.eye = {0, 1, 7}, .viewer = Viewer::local}, .lights = lights, .objects = objects, .background = rgb(0x102030)};

    shade16_light c_lights[4]{shade16_ambient_light(shade16_rgb(0x303030)),
                              shade16_directional_light({SHADE16_Q16(1), SHADE16_Q16(2), SHADE16_Q16(3)}, shade16_rgb(0xFFE0C0), SHADE16_INTENSITY(6, 10)),
                              shade16_point_light({SHADE16_Q16(-3), SHADE16_Q16(2), SHADE16_Q16(2)}, shade16_rgb(0x80A0FF), SHADE16_INTENSITY(12, 1)),
                              shade16_spot_light({0, SHADE16_Q16(4), SHADE16_Q16(2)},
                                                 {{0, SHADE16_Q16(-4), SHADE16_Q16(-2)}, SHADE16_DEGREES(10), SHADE16_DEGREES(30), SHADE16_Q16(3)},
                                                 shade16_rgb(0xFFFFFF), SHADE16_INTENSITY(2, 1))};
    shade16_object c_objects[shapes]{{&c_mesh[0], *shade16_find_material("brass"), shade16_default_pose()},
                                     {&c_mesh[1], *shade16_find_material("ruby"), shade16_default_pose()},
                                     {&c_mesh[2], *shade16_find_material("jade"), shade16_default_pose()}};
    shade16_scene c_scene{shade16_default_camera(), c_lights, c_objects, 4, shapes, shade16_rgb(0x102030), width, height};

    BothScenes() {
        lights[2].attenuation = {0, 0, 1, 0}, lights[2].range = 9;
        c_lights[2].attenuation = {0, 0, 65536, 0}, c_lights[2].range = SHADE16_Q16(9);
        objects[1].material.shading = Shading::phong, objects[1].material.reflection = Reflection::phong;
        c_objects[1].material.shading = SHADE16_SHADING_PHONG, c_objects[1].material.reflection = SHADE16_REFLECTION_PHONG;
        objects[2].material.shading = Shading::flat;
        c_objects[2].material.shading = SHADE16_SHADING_FLAT;
        for (int32_t i = 0; i < shapes; ++i) {
            objects[i].pose.translation.x = Q16::from_int(2 * i - 2);
            c_objects[i].pose.translation.x = SHADE16_Q16(2 * i - 2);
        }
        objects[0].pose.scale.y = 0.5_q16;  // differs by axis
        c_objects[0].pose.scale.y = SHADE16_RATIO(1, 2);
        c_scene.camera.eye = {0, SHADE16_Q16(1), SHADE16_Q16(7)};
        c_scene.camera.viewer = SHADE16_VIEWER_LOCAL;
    }

    std::vector<uint16_t> expected(Component component = Component::all) {
        host::RuntimeRenderer<mediump> renderer(scene);
        renderer.begin({.component = component}, {width, height});
        return renderer.draw<Rgb565>();
    }
};

class SameScene : public testing::Test {
protected:
    void SetUp() override {
        memory.resize(shade16_workspace_bytes(&both.c_scene) / 8 + 1);
        ASSERT_EQ(shade16_init(memory.data(), memory.size() * 8, &both.c_scene, &renderer), SHADE16_OK);
    }
    /// Drawn in bands of seven rows.
    std::vector<uint16_t> drawn(const shade16_frame* frame) {
        std::vector<uint16_t> pixels(width * height), depth(width * 7);
        EXPECT_EQ(shade16_begin(renderer, frame), SHADE16_OK);
        for (int32_t y = 0; y < height; y += 7)
            EXPECT_EQ(shade16_draw_rgb565(renderer, pixels.data() + y * width, depth.data(), y, std::min(7, height - y)), SHADE16_OK);
        return pixels;
    }

    BothScenes both{};
    std::vector<uint64_t> memory{};
    shade16_renderer* renderer = nullptr;
};

TEST_F(SameScene, AsItWasPrepared) { EXPECT_EQ(drawn(nullptr), both.expected()); }

TEST_F(SameScene, OnlyHighlights) {
    shade16_frame frame{};
    frame.component = SHADE16_COMPONENT_SPECULAR;
    EXPECT_EQ(drawn(&frame), both.expected(Component::specular));
}

/// All that a frame may vary, an exponent included; and what was varied stays.
TEST_F(SameScene, VariedByAFrame) {
    const std::vector<uint16_t> before = drawn(nullptr);
    shade16_material materials[BothScenes::shapes];
    shade16_pose poses[BothScenes::shapes];
    for (int i = 0; i < BothScenes::shapes; ++i) materials[i] = both.c_objects[i].material, poses[i] = both.c_objects[i].pose;
    materials[0].shininess = SHADE16_Q16(100), materials[1].diffuse = shade16_rgb(0x00FF00);
    poses[2].rotation = shade16_multiply(shade16_rotate_z(SHADE16_DEGREES(30)), shade16_rotate_x(SHADE16_DEGREES(50)));
    both.c_lights[3].kind = SHADE16_LIGHT_POINT;
    shade16_camera camera = both.c_scene.camera;
    camera.projection = SHADE16_ORTHOGRAPHIC, camera.view_height = SHADE16_Q16(5);
    const shade16_frame frame{&camera, both.c_lights, poses, materials, 4, BothScenes::shapes, BothScenes::shapes, SHADE16_COMPONENT_ALL};

    both.objects[0].material.shininess = 100, both.objects[1].material.diffuse = rgb(0x00FF00);
    both.objects[2].pose.rotation = rotate_z(30_deg) * rotate_x(50_deg);
    both.lights[3].kind = LightKind::point;
    both.scene.camera.projection = Projection::orthographic, both.scene.camera.view_height = 5;
    const std::vector<uint16_t> expected = both.expected();
    EXPECT_NE(expected, before);
    EXPECT_EQ(drawn(&frame), expected);
    EXPECT_EQ(drawn(nullptr), expected);
}

}  // namespace
