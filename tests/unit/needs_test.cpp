#include "shade16/scene/needs.hpp"

#include <gtest/gtest.h>

#include "host_sim/report/terms.hpp"
#include "shade16/scene/shapes.hpp"

namespace shade16 {
namespace {

// What every scene below has: one convex object, lit, without light, seen without a divide.
constexpr Camera orthographic{.projection = Projection::orthographic};
constexpr Material matt{.diffuse = rgb(0x808080)};
constexpr Material shiny{.diffuse = rgb(0x808080), .specular = white};
constexpr Needs plain{.orthographic = true, .lit = true, .gouraud = true};

constexpr Needs needs_with(const Material& material, View<Light> lights, const Camera& camera = orthographic, const Pose& pose = {},
                           const Mesh& mesh = cube.mesh()) {
    const Object object[] = {{mesh, material, pose}};
    return needs_of(Scene{.camera = camera, .lights = lights, .objects = object});
}
constexpr Needs needs_with(const Material& material, const Light& light, const Camera& camera = orthographic) {
    const Light lights[] = {light};
    return needs_with(material, View<Light>(lights), camera);
}
// `plain` and one more.
constexpr Needs plus(bool Needs::*term) {
    Needs n = plain;
    n.*term = true;
    return n;
}

TEST(Needs, AnUnlitRoomNeedsNothingMore) { static_assert(needs_with(matt, View<Light>{}) == plain); }

TEST(Needs, AnEmptySceneNeedsNothing) {
    static_assert(needs_of(Scene{.camera = orthographic}) == Needs{.orthographic = true});
    static_assert(needs_of(Scene{}) == Needs{.perspective = true});
}

TEST(Needs, EachTermAloneSwitchesOnItsNeed) {
    Needs perspective = plain;
    perspective.perspective = true, perspective.orthographic = false;
    EXPECT_EQ(needs_with(matt, View<Light>{}, Camera{}), perspective);
    static_assert(needs_with(matt, ambient_light(white)) == plus(&Needs::ambient));
    static_assert(needs_with({.emissive = rgb(1)}, View<Light>{}) == plus(&Needs::ambient));
    static_assert(needs_with(matt, View<Light>{}, orthographic, {.scale = {1, 1, 2}}) == plus(&Needs::stretch));
    static_assert(needs_with(matt, View<Light>{}, orthographic, {.scale = {2, 2, 2}}) == plain);
    static_assert(needs_with(matt, View<Light>{}, orthographic, {}, torus<3, 3>.mesh()) == plus(&Needs::depth));

    Needs flat = plain;
    flat.flat = true, flat.gouraud = false;
    EXPECT_EQ(needs_with({.shading = Shading::flat}, View<Light>{}), flat);
    EXPECT_EQ(needs_with({.unlit = true}, View<Light>{}), (Needs{.orthographic = true, .unlit = true, .gouraud = true}));
    EXPECT_EQ(needs_with({.shading = Shading::flat, .unlit = true}, View<Light>{}), (Needs{.orthographic = true, .unlit = true, .gouraud = true}));
}

TEST(Needs, VertexColoursAreANeed) {
    static constexpr Rgb colors[24]{};
    Mesh mesh = cube.mesh();
    mesh.colors = colors;
    EXPECT_EQ(needs_with(matt, View<Light>{}, orthographic, {}, mesh), plus(&Needs::vertex_colors));
}

TEST(Needs, LightsBringTheirKindAndTheirTerms) {
    Needs directional = plain;
    directional.directional = directional.diffuse = true;
    EXPECT_EQ(needs_with(matt, directional_light({0, 0, 1})), directional);
    Needs point = plain;
    point.point = point.diffuse = true;
    EXPECT_EQ(needs_with(matt, point_light({0, 0, 1})), point);
    point.specular = point.halfway = true;
    EXPECT_EQ(needs_with(shiny, point_light({0, 0, 1})), point);
    point.attenuation = true;
    EXPECT_EQ(needs_with(shiny, Light{.kind = LightKind::point, .attenuation = {.linear = 1}}), point);
    directional.specular = directional.halfway = true, directional.diffuse = false;
    EXPECT_EQ(needs_with({.diffuse = black, .specular = white}, directional_light({0, 0, 1})), directional);
}

TEST(Needs, LampsBringWhatShapesThem) {
    const auto added = [](const Light& lamp) {
        const Needs n = needs_with(matt, lamp);
        EXPECT_TRUE(n.point && n.diffuse);
        return n;
    };
    Needs lamp = plain;
    lamp.point = lamp.diffuse = true;
    Needs falling = lamp, ending = lamp, spot = lamp;
    falling.falloff = ending.range = spot.spot = true;
    EXPECT_EQ(added({.kind = LightKind::point, .attenuation = {.power = 1}}), falling);
    EXPECT_EQ(added({.kind = LightKind::point, .range = 5}), ending);
    EXPECT_EQ(added(spot_light({0, 0, 1}, {})), spot);
    spot.spot_exponent = true;
    EXPECT_EQ(added(spot_light({0, 0, 1}, {.exponent = 2})), spot);
    EXPECT_EQ(added({.kind = LightKind::point, .range = -1, .spot = {.exponent = 2}}), lamp) << "a cone is a spot's";
    Light sun = directional_light({0, 0, 1});
    sun.range = 5, sun.attenuation.power = 1;
    EXPECT_EQ(needs_with(matt, sun), needs_with(matt, directional_light({0, 0, 1})));
}

TEST(Needs, HighlightsBringTheirReflection) {
    Material phong = shiny;
    phong.reflection = Reflection::phong;
    const Needs n = needs_with(phong, directional_light({0, 0, 1}));
    EXPECT_TRUE(n.specular && n.reflected && !n.halfway);
    phong.specular = black;
    EXPECT_EQ(needs_with(phong, directional_light({0, 0, 1})), needs_with(matt, directional_light({0, 0, 1})));
}

TEST(Needs, BlackIsNoTerm) {
    EXPECT_FALSE(needs_with(matt, directional_light({0, 0, 1})).specular);
    EXPECT_FALSE(needs_with(shiny, Light{.specular = black}).specular);
    EXPECT_FALSE(needs_with(shiny, Light{.diffuse = black}).diffuse);
    EXPECT_EQ(needs_with({.diffuse = black}, point_light({0, 0, 1})), plain);
    EXPECT_EQ(needs_with(shiny, Light{.diffuse = black, .specular = black}), plain);
    EXPECT_EQ(needs_with({.ambient = black, .diffuse = white}, ambient_light(white)), plain);
    EXPECT_EQ(needs_with(matt, ambient_light(black)), plain);
}

TEST(Needs, ALampThatIsOffIsNoTerm) {
    EXPECT_EQ(needs_with(shiny, point_light({0, 0, 1}, white, 0)), plain);
    EXPECT_EQ(needs_with(shiny, Light{.kind = LightKind::ambient, .intensity = 0}), plain);
}

TEST(Needs, ALocalViewerIsANeedOnlyOfHighlightsInPerspective) {
    constexpr Camera local{.viewer = Viewer::local};
    constexpr Camera local_orthographic{.projection = Projection::orthographic, .viewer = Viewer::local};
    EXPECT_TRUE(needs_with(shiny, directional_light({0, 0, 1}), local).local_viewer);
    EXPECT_FALSE(needs_with(matt, directional_light({0, 0, 1}), local).local_viewer);
    EXPECT_FALSE(needs_with(shiny, directional_light({0, 0, 1}), local_orthographic).local_viewer);
    EXPECT_FALSE(needs_with(shiny, directional_light({0, 0, 1}), Camera{}).local_viewer);
}

TEST(Needs, TwoConvexObjectsNeedDepth) {
    const Object objects[] = {{cube.mesh(), matt, {}}, {cube.mesh(), matt, {}}};
    EXPECT_EQ(needs_of(Scene{.camera = orthographic, .objects = objects}), plus(&Needs::depth));
}

TEST(Needs, OfAnUnlitObjectLightsDoNotCount) {
    EXPECT_EQ(needs_with({.specular = white, .emissive = white, .unlit = true}, point_light({0, 0, 1})), (Needs{.orthographic = true, .unlit = true, .gouraud = true}));
}

TEST(Needs, TheUnionHasTheTermsOfBoth) {
    static_assert(host::every_term_has_a_name);
    for (const host::Term& a : host::terms)
        for (const host::Term& b : host::terms) {
            Needs left{}, right{}, both{};
            left.*a.is_needed = right.*b.is_needed = both.*a.is_needed = both.*b.is_needed = true;
            EXPECT_EQ(left | right, both);
            EXPECT_EQ(left | right, right | left);
        }
    static_assert((all_needs | Needs{}) == all_needs);
}

TEST(Needs, CoversIsContainment) {
    for (const host::Term& term : host::terms) {
        Needs one{}, without = all_needs;
        one.*term.is_needed = true, without.*term.is_needed = false;
        EXPECT_TRUE(covers(all_needs, one));
        EXPECT_TRUE(covers(one, one));
        EXPECT_TRUE(covers(one, Needs{}));
        EXPECT_FALSE(covers(Needs{}, one));
        EXPECT_FALSE(covers(without, one));
        EXPECT_FALSE(covers(without, all_needs));
        EXPECT_TRUE(all_needs.*term.is_needed);
    }
}

}  // namespace
}  // namespace shade16
