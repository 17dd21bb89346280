// What the renderer promises beyond one picture (renderer_pictures.hpp): what it lights, that nothing leaks, what may vary, and that it survives.
#include <gtest/gtest.h>

#include <random>

#include "tests/renderer/frames.hpp"

namespace shade16::host {
namespace {

TEST(Renderer, LightsOnlyTheVerticesOfVisibleTriangles) {
    auto memory = std::make_unique<Workspace<torus_scene, mediump>>();
    Renderer<torus_scene, mediump> renderer(*memory);
    frame_of<decltype(renderer), Rgb565>(renderer);
    uint32_t lit = 0;
    std::vector<bool> visible(brass_torus[0].mesh.positions.count, false);
    for (const Triangle& t : brass_torus[0].mesh.triangles) {
        const auto &a = memory->vertices[t.a], &b = memory->vertices[t.b], &c = memory->vertices[t.c];
        if (doubled_area(a, b, c) < 0) visible[t.a] = visible[t.b] = visible[t.c] = true;
    }
    for (uint32_t i = 0; i < brass_torus[0].mesh.positions.count; ++i) {
        const bool is = memory->vertices[i].flags & is_lit;
        lit += is;
        EXPECT_LE(is, visible[i]) << "vertex " << i << " faces away and was lit";
    }
    EXPECT_GT(lit, 100u);
    EXPECT_LT(lit, brass_torus[0].mesh.positions.count * 3 / 4);
}

// A room seen from inside: a cube turned inside out covers every pixel, through the near plane and the guard band.
constexpr Triangle inside_out[] = {{2, 1, 0}, {3, 2, 0}, {6, 5, 4}, {7, 6, 4}, {10, 9, 8}, {11, 10, 8}, {14, 13, 12}, {15, 14, 12}, {18, 17, 16}, {19, 18, 16}, {22, 21, 20}, {23, 22, 20}};

constexpr Q16 room_size = 40;

TEST(Renderer, ARoomSeenFromInsideHasNoGaps) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int32_t> inside(-60000, 60000), anywhere(-65536, 65536);
    for (int i = 0; i < 300; ++i) {
        Mesh room = cube.mesh();
        room.triangles = inside_out;
        const Object objects[] = {{.mesh = room, .material = {.diffuse = white, .unlit = true}, .pose = {.scale = {room_size, room_size, room_size}}}};
        Scene scene{.objects = objects, .background = black};
        const auto at = [&](auto& of) { return Vec3{Q16::from_raw(of(random)), Q16::from_raw(of(random)), Q16::from_raw(of(random))}; };
        scene.camera.eye = at(inside) * room_size;
        scene.camera.target = at(anywhere) * room_size;
        scene.camera.fov_y = Angle{(1u << 28) + (static_cast<uint32_t>(i) << 21)};
        scene.camera.near_distance = Q16::from_raw(1 + i * 500);
        scene.camera.far_distance = Q16::from_int(200);
        const auto pixels = at_run_time<mediump>(scene);
        EXPECT_EQ(std::count(pixels.begin(), pixels.end(), nearest_pixel<Rgb565>(white)), screen.width * screen.height) << "camera " << i;
    }
}

TEST(Renderer, ConvexObjectsNeedNoDepth) {
    static_assert(!needs_of(cube_scene).depth);
    constexpr Needs with_depth = needs_of(cube_scene) | Needs{.depth = true};
    EXPECT_EQ((compiled<cube_scene, mediump, VertexStore::keep, with_depth>()), (compiled<cube_scene, mediump>()));
}

TEST(Renderer, SwappedFramesAreTheFramesWithBytesSwapped) {
    RuntimeRenderer<mediump> renderer(crowd_scene);
    renderer.begin({}, screen);
    auto pixels = renderer.draw<Rgb565Swapped>();
    for (auto& p : pixels) p = static_cast<uint16_t>(p << 8 | p >> 8);
    EXPECT_EQ(pixels, renderer.draw<Rgb565>());
}

// Colours and exponents that vary at run time draw what a scene compiled with them does.
constexpr Object before[] = {{.mesh = torus<24, 12>.mesh(), .material = {.diffuse = rgb(0x405060), .specular = rgb(0x101010), .shininess = 3}}};
constexpr Object after[] = {{.mesh = torus<24, 12>.mesh(), .material = {.ambient = rgb(0x111111), .diffuse = rgb(0x602040), .specular = white, .emissive = rgb(0x080400), .shininess = 77.7_q16}}};
constexpr Scene scene_before{.camera = near_by, .lights = lamps, .objects = before}, scene_after{.camera = near_by, .lights = lamps, .objects = after};

template <class Tier>
void expect_materials_vary() {
    auto memory = std::make_unique<Workspace<scene_before, Tier>>();
    Renderer<scene_before, Tier, VertexStore::keep, needs_of(scene_before) | needs_of(scene_after)> renderer(*memory);
    Shininess<Tier> kernel{};  // in RAM
    const Shininess<Tier>* const kernels[] = {&kernel};
    const auto frame = [&](const Object& object) {
        kernel = shininess<Tier>(object.material.shininess);
        renderer.use_shininess(kernels);
        std::vector<Rgb565::Pixel> pixels(static_cast<std::size_t>(screen.width * screen.height));
        std::vector<uint16_t> depth(pixels.size());
        renderer.begin({.materials = &object.material}, screen);
        renderer.draw(Band<Rgb565>{pixels.data(), depth.data(), screen.width, 0, screen.height});
        return pixels;
    };
    EXPECT_EQ(frame(after[0]), (compiled<scene_after, Tier>())) << Tier::name;
    EXPECT_EQ(frame(before[0]), (compiled<scene_before, Tier>())) << Tier::name;
    EXPECT_NE(frame(before[0]), frame(after[0]));
}
TEST(Renderer, MaterialsVaryFromFrameToFrame) {
    expect_materials_vary<lowp>();
    expect_materials_vary<mediump>();
    expect_materials_vary<highp>();
}

// A kernel that changes in its place is asked for anew by the table of light, too.
constexpr Material looked_up(Q16 exponent) { return {.specular = white, .shininess = exponent, .shading = Shading::phong, .light_table = LightTable::bilinear}; }
constexpr Object dull_table[] = {{.mesh = torus<24, 12>.mesh(), .material = looked_up(3)}}, sharp_table[] = {{.mesh = torus<24, 12>.mesh(), .material = looked_up(90)}};
constexpr Scene dull_scene{.lights = sun, .objects = dull_table}, sharp_scene{.lights = sun, .objects = sharp_table};

TEST(Renderer, TablesOfLightFollowTheExponent) {
    auto memory = std::make_unique<Workspace<dull_scene, mediump>>();
    Renderer<dull_scene, mediump> renderer(*memory);
    Shininess<mediump> kernel{};
    const Shininess<mediump>* const kernels[] = {&kernel};
    const auto frame = [&](Q16 exponent) {
        kernel = shininess<mediump>(exponent);
        renderer.use_shininess(kernels);
        return frame_of<decltype(renderer), Rgb565>(renderer);
    };
    EXPECT_EQ(frame(3), (compiled<dull_scene, mediump>()));
    EXPECT_EQ(frame(90), (compiled<sharp_scene, mediump>()));
    EXPECT_NE(frame(3), frame(90));
}

// Nothing undefined whatever the numbers: the sanitizer build runs this, too.
TEST(Renderer, SurvivesRandomScenes) {
    std::mt19937 random(3);
    const auto any = [&] { return Q16::from_raw(static_cast<int32_t>(random()) >> (random() % 31)); };
    const auto vec = [&] { return Vec3{any(), any(), any()}; };
    for (int i = 0; i < 3000; ++i) {
        std::vector<Light> lights;
        for (uint32_t k = random() % 4; k > 0; --k)
            lights.push_back({.kind = static_cast<LightKind>(random() % 4), .position = vec(), .intensity = Scaled{static_cast<uint32_t>(random()) | 0x80000000u, static_cast<int>(random() % 40) - 20},
                              .space = static_cast<Space>(random() % 3), .attenuation = {any(), any(), any(), any()},
                              .range = any(), .spot = {vec(), {static_cast<uint32_t>(random())}, {static_cast<uint32_t>(random())}, any()}});
        Mesh mesh = random() % 2 ? torus<24, 12>.mesh() : random() % 2 ? textured_torus<12, 6>.mesh() : textured_cube.mesh();
        mesh.texcoord_bits = static_cast<int8_t>(random() % 16);
        mesh.fraction_bits = static_cast<int8_t>(random() % 31);
        mesh.centre = vec();
        Object object{.mesh = mesh, .material = classic_materials[random() % 24].material, .pose = {rotate_x({static_cast<uint32_t>(random())}), {any(), any(), any()}, vec()}};
        object.material.shading = static_cast<Shading>(random() % 3);
        object.material.normal_path = static_cast<NormalPath>(random() % 2);
        object.material.shininess = any();
        object.material.reflection = static_cast<Reflection>(random() % 2);
        if (random() % 2) object.material.texture = &chequers;
        object.material.light_table = static_cast<LightTable>(random() % 3);
        if (random() % 2) object.material.bump = &relief;
        object.material.filter = static_cast<Filter>(random() % 2), object.material.mapping = static_cast<Mapping>(random() % 2);
        object.material.unlit = random() % 8 == 0;
        const Scene scene{.camera = {vec(), vec(), vec(), static_cast<Projection>(random() % 2), static_cast<Viewer>(random() % 2), {static_cast<uint32_t>(random())}, any(), any(), any()},
                          .lights = {lights.data(), static_cast<uint32_t>(lights.size())}, .objects = {&object, 1}};
        const Viewport viewport{1 + static_cast<int>(random() % 48), 1 + static_cast<int>(random() % 32)};
        const auto draw = [&](auto tier) {
            RuntimeRenderer<decltype(tier)> renderer(scene);
            renderer.begin({.component = static_cast<Component>(i / 3 % 4)}, viewport);
            renderer.template draw<Rgb565>();
            renderer.template draw<Rgb888>();
        };
        i % 3 == 0 ? draw(lowp{}) : i % 3 == 1 ? draw(mediump{}) : draw(highp{});
    }
}

}  // namespace
}  // namespace shade16::host
