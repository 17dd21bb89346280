// Every status of shade16.h, provoked; and what is drawn when nothing is wrong.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string>

#include "firmware/c/terms.hpp"
#include "small_scene.hpp"

namespace {

/// A scene with one thing wrong is refused with one status, and needs no memory.
template <class Spoil>
void expect_refused(shade16_status expected, Spoil spoil) {
    SmallScene s;
    spoil(s);
    EXPECT_EQ(s.init(), expected) << shade16_status_text(expected);
    EXPECT_EQ(s.renderer, nullptr);
    EXPECT_EQ(shade16_workspace_bytes(&s.scene), 0u);
}

TEST(CStatus, AGoodSceneIsDrawn) {
    SmallScene s;
    ASSERT_EQ(s.init(), SHADE16_OK);
    ASSERT_EQ(s.begin(), SHADE16_OK);
    ASSERT_EQ(s.draw(), SHADE16_OK);
    EXPECT_EQ(std::set<uint16_t>(s.pixels.begin(), s.pixels.end()).size(), 2u);  // the square and the background
}

TEST(CStatus, NullArguments) {
    SmallScene s;
    EXPECT_EQ(shade16_init(nullptr, 1000, &s.scene, &s.renderer), SHADE16_NULL_ARGUMENT);
    EXPECT_EQ(shade16_init(s.memory.data(), 1000, nullptr, &s.renderer), SHADE16_NULL_ARGUMENT);
    EXPECT_EQ(shade16_init(s.memory.data(), 1000, &s.scene, nullptr), SHADE16_NULL_ARGUMENT);
    EXPECT_EQ(shade16_workspace_bytes(nullptr), 0u);
    EXPECT_EQ(shade16_begin(nullptr, nullptr), SHADE16_NULL_ARGUMENT);
    EXPECT_EQ(s.draw(), SHADE16_NULL_ARGUMENT);
    ASSERT_EQ(s.init(), SHADE16_OK);
    ASSERT_EQ(s.begin(), SHADE16_OK);
    EXPECT_EQ(shade16_draw_rgb565(s.renderer, nullptr, s.depth.data(), 0, 1), SHADE16_NULL_ARGUMENT);
}

TEST(CStatus, NullArraysAndMeshes) {
    expect_refused(SHADE16_NULL_ARRAY, [](SmallScene& s) { s.scene.lights = nullptr; });
    expect_refused(SHADE16_NULL_ARRAY, [](SmallScene& s) { s.scene.objects = nullptr; });
    expect_refused(SHADE16_NULL_ARRAY, [](SmallScene& s) { s.mesh.positions = nullptr; });
    expect_refused(SHADE16_NULL_ARRAY, [](SmallScene& s) { s.mesh.triangles = nullptr; });
    expect_refused(SHADE16_NULL_MESH, [](SmallScene& s) { s.objects[0].mesh = nullptr; });
}

TEST(CStatus, Memory) {
    SmallScene s;
    const size_t bytes = shade16_workspace_bytes(&s.scene);
    EXPECT_LE(bytes, SHADE16_WORKSPACE_BYTES(1, 1, 4, 0));
    EXPECT_EQ(shade16_init(s.memory.data(), bytes - 1, &s.scene, &s.renderer), SHADE16_MEMORY_TOO_SMALL);
    EXPECT_EQ(shade16_init(reinterpret_cast<char*>(s.memory.data()) + 4, 8000, &s.scene, &s.renderer), SHADE16_MEMORY_MISALIGNED);
    EXPECT_EQ(shade16_init(s.memory.data(), bytes, &s.scene, &s.renderer), SHADE16_OK);
}

/// Nothing is written behind the memory that shade16_workspace_bytes asks for.
TEST(CStatus, MemoryIsEnough) {
    SmallScene s;
    s.scene.object_count = 2;
    s.objects[1].material.shading = SHADE16_SHADING_FLAT;
    s.objects[1].material.specular = shade16_rgb(0xFFFFFF);
    const size_t bytes = shade16_workspace_bytes(&s.scene);
    EXPECT_LE(bytes, SHADE16_WORKSPACE_BYTES(2, 1, 8, 2));
    std::vector<uint64_t> exact((bytes + 7) / 8, 0x5A5A5A5A5A5A5A5Au);
    ASSERT_EQ(shade16_init(exact.data(), bytes, &s.scene, &s.renderer), SHADE16_OK);
    ASSERT_EQ(s.begin(), SHADE16_OK);
    EXPECT_EQ(s.draw(), SHADE16_OK);
}

TEST(CStatus, MisalignedArrays) {
    SmallScene s;
    char* const odd = reinterpret_cast<char*>(s.memory.data()) + 8001;
    expect_refused(SHADE16_ARRAY_MISALIGNED, [&](SmallScene& t) { t.mesh.positions = reinterpret_cast<shade16_position*>(odd); });
    ASSERT_EQ(s.init(), SHADE16_OK);
    ASSERT_EQ(s.begin(), SHADE16_OK);
    EXPECT_EQ(shade16_draw_rgb565(s.renderer, reinterpret_cast<uint16_t*>(odd), s.depth.data(), 0, 1), SHADE16_ARRAY_MISALIGNED);
    EXPECT_EQ(shade16_draw_rgb565_swapped(s.renderer, s.pixels.data(), reinterpret_cast<uint16_t*>(odd), 0, 1), SHADE16_ARRAY_MISALIGNED);
}

TEST(CStatus, Scenes) {
    expect_refused(SHADE16_TOO_MANY_LIGHTS, [](SmallScene& s) { s.scene.light_count = SHADE16_MAX_LIGHTS + 1; });
    expect_refused(SHADE16_TOO_MANY_OBJECTS, [](SmallScene& s) { s.scene.object_count = SHADE16_MAX_OBJECTS + 1; });
    expect_refused(SHADE16_TOO_MANY_VERTICES, [](SmallScene& s) { s.mesh.vertex_count = SHADE16_MAX_VERTICES + 1; });
    expect_refused(SHADE16_TOO_MANY_TRIANGLES, [](SmallScene& s) { s.mesh.triangle_count = SHADE16_MAX_TRIANGLES + 1; });
    expect_refused(SHADE16_INDEX_OUT_OF_RANGE, [](SmallScene& s) { s.triangles[1].c = 4; });
    expect_refused(SHADE16_FRACTION_BITS_OUT_OF_RANGE, [](SmallScene& s) { s.mesh.fraction_bits = 31; });
    expect_refused(SHADE16_FRACTION_BITS_OUT_OF_RANGE, [](SmallScene& s) { s.mesh.fraction_bits = -1; });
    expect_refused(SHADE16_SCALE_NOT_POSITIVE, [](SmallScene& s) { s.objects[0].pose.scale.y = 0; });
    expect_refused(SHADE16_UNKNOWN_VALUE, [](SmallScene& s) { s.lights[0].kind = 4; });
    expect_refused(SHADE16_UNKNOWN_VALUE, [](SmallScene& s) { s.lights[0].space = 3; });
    expect_refused(SHADE16_UNKNOWN_VALUE, [](SmallScene& s) { s.objects[0].material.shading = 3; });
    expect_refused(SHADE16_UNKNOWN_VALUE, [](SmallScene& s) { s.objects[0].material.reflection = 2; });
    expect_refused(SHADE16_UNKNOWN_VALUE, [](SmallScene& s) { s.objects[0].material.normal_path = 2; });
    expect_refused(SHADE16_UNKNOWN_VALUE, [](SmallScene& s) { s.scene.camera.projection = 2; });
    expect_refused(SHADE16_UNKNOWN_VALUE, [](SmallScene& s) { s.scene.camera.viewer = 2; });
    expect_refused(SHADE16_SCREEN_SIZE, [](SmallScene& s) { s.scene.width_px = 0; });
    expect_refused(SHADE16_SCREEN_SIZE, [](SmallScene& s) { s.scene.height_px = 2049; });
    expect_refused(SHADE16_FIELD_OF_VIEW, [](SmallScene& s) { s.scene.camera.fov_y = 0; });
    expect_refused(SHADE16_FIELD_OF_VIEW, [](SmallScene& s) { s.scene.camera.fov_y = SHADE16_DEGREES(180); });
    expect_refused(SHADE16_NEAR_AND_FAR, [](SmallScene& s) { s.scene.camera.near_distance = 0; });
    expect_refused(SHADE16_NEAR_AND_FAR, [](SmallScene& s) { s.scene.camera.far_distance = s.scene.camera.near_distance; });
    expect_refused(SHADE16_VIEW_HEIGHT, [](SmallScene& s) { s.scene.camera.projection = SHADE16_ORTHOGRAPHIC, s.scene.camera.view_height = 0; });
}

TEST(CStatus, NormalsAreAskedForWhereSomethingSmoothIsLit) {
    SmallScene s;
    s.mesh.normals = nullptr;
    EXPECT_EQ(s.init(), SHADE16_NO_NORMALS);
    EXPECT_EQ(s.renderer, nullptr);
    s.objects[0].material.shading = SHADE16_SHADING_FLAT;
    EXPECT_EQ(s.init(), SHADE16_OK);
}

TEST(CStatus, Frames) {
    SmallScene s;
    ASSERT_EQ(s.init(), SHADE16_OK);
    shade16_frame frame{};
    frame.component = 4;
    EXPECT_EQ(s.begin(&frame), SHADE16_UNKNOWN_VALUE);
    frame = {};
    frame.poses = &s.objects[0].pose;
    EXPECT_EQ(s.begin(&frame), SHADE16_COUNT_DIFFERS);
    frame = {};
    frame.lights = s.lights, frame.light_count = 2;
    EXPECT_EQ(s.begin(&frame), SHADE16_COUNT_DIFFERS);
    frame = {};
    frame.materials = &s.objects[0].material, frame.material_count = 1;
    s.objects[0].material.shading = SHADE16_SHADING_FLAT;
    EXPECT_EQ(s.begin(&frame), SHADE16_FLATNESS_CHANGED);
    s.objects[0].material.shading = SHADE16_SHADING_PHONG;
    EXPECT_EQ(s.begin(&frame), SHADE16_OK);
    frame.poses = &s.objects[0].pose, frame.pose_count = 1;
    s.objects[0].pose.scale.x = -1;
    EXPECT_EQ(s.begin(&frame), SHADE16_SCALE_NOT_POSITIVE);
    EXPECT_EQ(s.draw(), SHADE16_NOT_BEGUN);  // a frame that was refused is none
}

TEST(CStatus, Bands) {
    SmallScene s;
    ASSERT_EQ(s.init(), SHADE16_OK);
    EXPECT_EQ(s.draw(), SHADE16_NOT_BEGUN);
    ASSERT_EQ(s.begin(), SHADE16_OK);
    for (const auto& [first, rows] : {std::pair{-1, 2}, {0, 0}, {0, 13}, {12, 1}, {11, 2}, {INT32_MAX, INT32_MAX}, {1, INT32_MAX}, {INT32_MIN, 1}})
        EXPECT_EQ(s.draw(first, rows), SHADE16_BAND_OUTSIDE) << first << ", " << rows;
    EXPECT_EQ(shade16_draw_rgb565(s.renderer, s.pixels.data(), nullptr, 0, 1), SHADE16_NO_DEPTH);
    EXPECT_EQ(s.draw(11, 1), SHADE16_OK);
}

/// A term that is there but for itself has a status of its own, whose sentence names it.
TEST(CStatus, EveryTermThatIsLackingIsNamed) {
    using namespace shade16;
    std::set<shade16_status> seen;
#define EXPECT_NAMED(term, NAME)                                                                               \
    {                                                                                                          \
        Needs have = all_needs;                                                                                \
        have.term = false;                                                                                     \
        EXPECT_EQ(c::first_lacking(have, all_needs), SHADE16_LACKS_##NAME);                                    \
        EXPECT_NE(std::string(shade16_status_text(SHADE16_LACKS_##NAME)).find("'" #term "'"), std::string::npos); \
        seen.insert(SHADE16_LACKS_##NAME);                                                                     \
    }
    SHADE16_C_FOR_EACH_TERM(EXPECT_NAMED)
#undef EXPECT_NAMED
    EXPECT_EQ(seen.size(), sizeof(Needs) - 5);
    EXPECT_EQ(c::first_lacking(all_needs, all_needs), SHADE16_OK);
}

TEST(CStatus, EveryStatusHasASentenceOfItsOwn) {
    std::set<std::string> sentences;
    const std::string none = shade16_status_text(-1);
    for (shade16_status status = 0; status < 128; ++status)
        if (const std::string text = shade16_status_text(status); text != none) {
            EXPECT_EQ(text.back(), '.') << text;
            EXPECT_TRUE(status == SHADE16_OK || text.find("xpected") != std::string::npos) << text;
            EXPECT_TRUE(sentences.insert(text).second) << text;
        }
    EXPECT_EQ(sentences.size(), 1u + 6 + 13 + 5 + 24);
}

/// docs/c.md has a row of every sentence.
TEST(CStatus, ThePageHasEverySentence) {
    std::ifstream file(SHADE16_DOCS "/c.md");
    const std::string page((std::istreambuf_iterator<char>(file)), {});
    const std::string none = shade16_status_text(-1);
    for (shade16_status status = 1; status < SHADE16_LACKS_PERSPECTIVE; ++status)
        if (const std::string text = shade16_status_text(status); text != none) {
            EXPECT_TRUE(page.find("` | " + text + " |") != std::string::npos) << text;
        }
}

TEST(CHelpers, MaterialsAreFoundByName) {
    ASSERT_NE(shade16_find_material("brass"), nullptr);
    EXPECT_EQ(shade16_find_material("brass")->shininess, 1828286);
    EXPECT_EQ(shade16_find_material("bras"), nullptr);
    EXPECT_EQ(shade16_find_material("brass2"), nullptr);
    EXPECT_EQ(shade16_find_material(nullptr), nullptr);
}

/// Structs of random bytes, among them some that pass: nothing is undefined, which the sanitizers hold.
TEST(CStatus, RandomScenesAreRefusedOrDrawn) {
    std::mt19937 dice(1);
    const auto randomize = [&](void* object, size_t bytes) {
        for (size_t i = 0; i < bytes; ++i)
            if (dice() % 4 == 0) static_cast<unsigned char*>(object)[i] = static_cast<unsigned char>(dice() % 3 == 0 ? dice() : dice() % 4);
    };
    int drawn = 0;
    for (int i = 0; i < 20000; ++i) {
        SmallScene s;
        s.scene.object_count = 1 + dice() % 2;
        if (dice() % 2) s.mesh.colors = s.colors;
        if (dice() % 2) randomize(&s.scene.camera, sizeof s.scene.camera);
        if (dice() % 2) randomize(s.lights, sizeof s.lights);
        if (dice() % 2) randomize(&s.objects[0].material, sizeof s.objects[0].material);
        if (dice() % 2) randomize(&s.objects[0].pose, sizeof s.objects[0].pose);
        if (dice() % 2) randomize(s.positions, sizeof s.positions);
        if (dice() % 8 == 0) randomize(s.triangles, sizeof s.triangles);
        if (dice() % 8 == 0) s.mesh.fraction_bits = static_cast<int8_t>(dice());
        if (s.init() != SHADE16_OK || s.begin() != SHADE16_OK) continue;
        drawn += s.draw() == SHADE16_OK;
    }
    EXPECT_GT(drawn, 1000);
}

}  // namespace
