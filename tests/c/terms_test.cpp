// A library of a few terms: it draws what it has the terms for, without depth, and names what it lacks.
#include <gtest/gtest.h>

#include <set>

#include "small_scene.hpp"

namespace {

template <class Change>
void expect_lacking(shade16_status expected, Change change) {
    SmallScene s;
    change(s);
    EXPECT_EQ(s.init(), expected) << shade16_status_text(expected);
    EXPECT_EQ(s.renderer, nullptr);
}

TEST(CTerms, WhatIsThereIsDrawnWithoutDepth) {
    SmallScene s;
    ASSERT_EQ(s.init(), SHADE16_OK);
    ASSERT_EQ(s.begin(), SHADE16_OK);
    ASSERT_EQ(shade16_draw_rgb565(s.renderer, s.pixels.data(), nullptr, 0, SmallScene::height), SHADE16_OK);
    EXPECT_EQ(std::set<uint16_t>(s.pixels.begin(), s.pixels.end()).size(), 2u);
}

TEST(CTerms, WhatIsLackingIsNamed) {
    expect_lacking(SHADE16_LACKS_ORTHOGRAPHIC, [](SmallScene& s) { s.scene.camera.projection = SHADE16_ORTHOGRAPHIC; });
    expect_lacking(SHADE16_LACKS_DEPTH, [](SmallScene& s) { s.scene.object_count = 2; });
    expect_lacking(SHADE16_LACKS_DEPTH, [](SmallScene& s) { s.mesh.convex = 0; });
    expect_lacking(SHADE16_LACKS_UNLIT, [](SmallScene& s) { s.objects[0].material.unlit = 1; });
    expect_lacking(SHADE16_LACKS_FLAT, [](SmallScene& s) { s.objects[0].material.shading = SHADE16_SHADING_FLAT; });
    expect_lacking(SHADE16_LACKS_PHONG, [](SmallScene& s) { s.objects[0].material.shading = SHADE16_SHADING_PHONG; });
    expect_lacking(SHADE16_LACKS_VERTEX_COLORS, [](SmallScene& s) { s.mesh.colors = s.colors; });
    expect_lacking(SHADE16_LACKS_SPECULAR, [](SmallScene& s) { s.objects[0].material.specular = shade16_rgb(0xFFFFFF); });
    expect_lacking(SHADE16_LACKS_POINT, [](SmallScene& s) { s.lights[0].kind = SHADE16_LIGHT_POINT; });
    expect_lacking(SHADE16_LACKS_STRETCH, [](SmallScene& s) { s.objects[0].pose.scale.x = SHADE16_Q16(2); });
}

/// A frame can not bring a term that the scene was prepared without.
TEST(CTerms, AFrameIsHeldToThemToo) {
    SmallScene s;
    ASSERT_EQ(s.init(), SHADE16_OK);
    shade16_frame frame{};
    frame.lights = s.lights, frame.light_count = 1;
    s.lights[0].kind = SHADE16_LIGHT_SPOT;
    EXPECT_EQ(s.begin(&frame), SHADE16_LACKS_POINT);
    EXPECT_EQ(s.draw(), SHADE16_NOT_BEGUN);
    s.lights[0].kind = SHADE16_LIGHT_DIRECTIONAL;
    EXPECT_EQ(s.begin(&frame), SHADE16_OK);
}

}  // namespace
