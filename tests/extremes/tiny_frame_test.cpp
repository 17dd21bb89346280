// Scenes that draw nothing, scenes of numbers outside their domain, and the smallest targets: drawn by the compiler.
#include "extremes/tiny_frame.hpp"

namespace shade16::test {
namespace {

constexpr Rgb red = rgb(0xFF0000), blue = rgb(0x0000FF), grey = rgb(0x808080);
constexpr Material plain{.diffuse = red, .unlit = true};
constexpr Light headlight[] = {directional_light({0, 0, 1})};

// A quad of 2 x 2 at the origin, seen from (0, 0, 3): larger than this frame's field of view where it is enlarged.
constexpr Pose enlarged{.scale = {8, 8, 8}};
constexpr Object wall[] = {{.mesh = quad.mesh(), .material = plain, .pose = enlarged}};
constexpr Scene wall_scene{.objects = wall, .background = blue};

TEST(TinyFrame, AWallFillsTheFrame) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<wall_scene, decltype(tier)>(), red); }));
}

// --- Nothing to draw ---

constexpr Scene empty{.background = blue};
constexpr Object no_triangles[] = {{.mesh = {.positions = quad.positions, .normals = quad.normals}, .material = plain}};
constexpr Object no_vertices[] = {{.mesh = {}, .material = plain}};
constexpr Scene without_triangles{.objects = no_triangles, .background = blue}, without_vertices{.objects = no_vertices, .background = blue};

TEST(TinyFrame, AnEmptySceneIsItsBackground) {
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<empty>(), blue));
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<without_triangles>(), blue));
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<without_vertices>(), blue));
}

constexpr Triangle same_corners[] = {{0, 0, 0}, {1, 1, 2}, {2, 3, 2}};
constexpr Position16 on_a_line[] = {{-16384, -16384, 0}, {0, 0, 0}, {8192, 8192, 0}, {16384, 16384, 0}};
constexpr Triangle of_a_line[] = {{0, 1, 2}, {1, 3, 2}, {0, 3, 1}};
constexpr Object no_area[] = {{.mesh = {.positions = quad.positions, .triangles = same_corners}, .material = plain, .pose = enlarged},
                              {.mesh = {.positions = on_a_line, .triangles = of_a_line}, .material = plain, .pose = enlarged}};
constexpr Scene without_area{.objects = no_area, .background = blue};

TEST(TinyFrame, TrianglesWithoutAreaDrawNothing) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<without_area, decltype(tier)>(), blue); }));
}

constexpr Camera beyond{.eye = {0, 0, -3}, .target = {0, 0, -6}};  // looks away from the wall
constexpr Camera from_behind{.eye = {0, 0, -3}};
constexpr Camera in_its_plane{.eye = {3, 0, 0}};
constexpr Scene all_behind{.camera = beyond, .objects = wall, .background = blue}, turned_away{.camera = from_behind, .objects = wall, .background = blue},
    edge_on{.camera = in_its_plane, .objects = wall, .background = blue};

TEST(TinyFrame, WhatLiesBehindTheEyeIsNotDrawn) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<all_behind, decltype(tier)>(), blue); }));
}
TEST(TinyFrame, FacesThatFaceAwayAreNotDrawn) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<turned_away, decltype(tier)>(), blue); }));
}
TEST(TinyFrame, AFaceSeenEdgeOnIsNotDrawn) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<edge_on, decltype(tier)>(), blue); }));
}

constexpr Camera inside{.eye = {0.25_q16, 0.125_q16, 0}, .target = {1, 1, 1}, .fov_y = 120_deg, .near_distance = 0.01_q16};
constexpr Object around[] = {{.mesh = cube.mesh(), .material = plain}};
constexpr Scene inside_a_solid{.camera = inside, .objects = around, .background = blue};

TEST(TinyFrame, ACameraInsideASolidSeesItsBackgroundAlone) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<inside_a_solid, decltype(tier)>(), blue); }));
}

constexpr Object shrunk[] = {{.mesh = cube.mesh(), .material = plain, .pose = {.scale = {0, 0, 0}}}};
constexpr Object flattened[] = {{.mesh = cube.mesh(), .material = plain, .pose = {.scale = {1, 0, 0}}}};
constexpr Scene of_scale_zero{.objects = shrunk, .background = blue}, of_one_axis{.objects = flattened, .background = blue};

TEST(TinyFrame, AScaleOfZeroDrawsNothing) {
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<of_scale_zero>(), blue) && shows_only(frame_of<of_one_axis>(), blue));
}

// --- Cameras outside their domain ---

constexpr Camera with_near(Q16 near, Q16 far) { return {.eye = {0, 0, 0.5_q16}, .near_distance = near, .far_distance = far}; }
constexpr Scene near_zero{.camera = with_near(0, 100), .objects = wall, .background = blue};
constexpr Scene near_negative{.camera = with_near(-5, 100), .objects = wall, .background = blue};
constexpr Scene near_one_ulp{.camera = with_near(Q16::from_raw(1), 100), .objects = wall, .background = blue};
constexpr Scene far_before_near{.camera = with_near(0.25_q16, 0.125_q16), .objects = wall, .background = blue};

TEST(TinyFrame, ANearPlaneAtOrBehindTheEyeIsOneUlpAway) {
    constexpr auto nearest = frame_of<near_one_ulp>();
    EXPECT_AT_COMPILE_TIME(shows_only(nearest, red));
    EXPECT_AT_COMPILE_TIME(same_pixels(frame_of<near_zero>(), nearest) && same_pixels(frame_of<near_negative>(), nearest));
}
TEST(TinyFrame, AFarPlaneBeforeTheNearOneStillDraws) { static_assert(shows_only(frame_of<far_before_near>(), red)); }

constexpr Camera with_fov(Angle fov) { return {.fov_y = fov}; }
constexpr Scene fov_none{.camera = with_fov({0}), .objects = wall, .background = blue}, fov_half_turn{.camera = with_fov(180_deg), .objects = wall, .background = blue},
    fov_wider{.camera = with_fov(270_deg), .objects = wall, .background = blue};

TEST(TinyFrame, AFieldOfViewOutsideItsRangeIsTheNearestOne) {
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<fov_none>(), red) && "the middle of the wall, as through a telescope");
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<fov_half_turn>(), blue) && shows_only(frame_of<fov_wider>(), blue) && "the wall is a point");
}

constexpr Q16 largest = Q16::from_raw(INT32_MAX), smallest = Q16::from_raw(INT32_MIN);
constexpr Camera farthest{.eye = {largest, largest, largest}, .target = {smallest, smallest, smallest}, .up = {smallest, 0, largest}, .near_distance = largest, .far_distance = largest};
constexpr Object farthest_wall[] = {{.mesh = quad.mesh(), .material = {.diffuse = red, .specular = white, .shininess = largest},
                                     .pose = {.scale = {largest, largest, largest}, .translation = {smallest, smallest, smallest}}}};
constexpr Light farthest_lights[] = {point_light({smallest, largest, smallest}), directional_light({smallest, smallest, smallest}), point_light({largest, largest, largest})};
constexpr Scene of_the_largest_numbers{.camera = farthest, .lights = farthest_lights, .objects = farthest_wall, .background = blue};
constexpr Q16 one_ulp = Q16::from_raw(1);
constexpr Camera nearest_camera{.eye = {0, 0, one_ulp}, .near_distance = one_ulp, .far_distance = one_ulp};
constexpr Object smallest_wall[] = {{.mesh = quad.mesh(), .material = {.diffuse = red, .specular = white, .shininess = one_ulp}, .pose = {.scale = {one_ulp, one_ulp, one_ulp}}}};
constexpr Light nearest_lights[] = {point_light({0, 0, one_ulp}), directional_light({0, 0, one_ulp})};
constexpr Scene of_the_smallest_numbers{.camera = nearest_camera, .lights = nearest_lights, .objects = smallest_wall, .background = blue};

// Every kind of lamp, shading and map, all of whose numbers are at an end of their type.
constexpr Light at_their_ends[] = {
    {.kind = LightKind::spot, .position = {smallest, largest, smallest}, .intensity = Scaled{UINT32_MAX, INT16_MAX}, .space = Space::view, .attenuation = {smallest, largest, smallest, largest},
     .range = largest, .spot = {{smallest, smallest, smallest}, {UINT32_MAX}, {UINT32_MAX}, largest}},
    {.kind = LightKind::point, .position = {one_ulp, {}, {}}, .intensity = Scaled{0x80000000u, INT16_MIN}, .space = Space::object, .attenuation = {0, 0, 0, smallest}, .range = one_ulp},
    {.position = {smallest, smallest, smallest}, .space = Space::view}};
constexpr uint16_t one_texel[] = {0xFFFF};
constexpr Slope8 one_slope[] = {{-128, -128}};
constexpr Texture texture_of_a_texel{one_texel, 0, 0};
constexpr SlopeMap relief_of_a_slope{one_slope, 0, 0, 127};
constexpr Material mapped{.diffuse = red, .specular = white, .shininess = smallest, .reflection = Reflection::phong, .shading = Shading::phong, .normal_path = NormalPath::spherical,
                          .texture = &texture_of_a_texel, .bump = &relief_of_a_slope, .filter = Filter::bilinear, .mapping = Mapping::perspective};
struct TwoSidedCube {  // so that something of it faces any camera, inside or outside
    Triangle triangles[24]{};
    Normal14 normals[24]{};  // of no length, too long, and about 2^-14
    constexpr TwoSidedCube() {
        const Normal14 odd[4] = {{}, {{-32768}, {-32768}, {-32768}}, {{32767}, {-32768}, {32767}}, {{1}, {}, {}}};
        for (uint32_t i = 0; i < 24; ++i) normals[i] = odd[i & 3];
        for (uint32_t i = 0; i < 12; ++i) {
            const Triangle t = textured_cube.triangles[i];
            triangles[i] = t, triangles[12 + i] = {t.c, t.b, t.a};
        }
    }
};
constexpr TwoSidedCube two_sided;
constexpr Mesh with_bits(int8_t fraction_bits, int8_t texcoord_bits) {
    Mesh mesh = textured_cube.mesh();
    mesh.triangles = two_sided.triangles, mesh.normals = two_sided.normals;
    mesh.fraction_bits = fraction_bits, mesh.texcoord_bits = texcoord_bits;
    return mesh;
}
constexpr Mesh far_off(Mesh mesh) { return mesh.centre = {smallest, largest, smallest}, mesh; }
constexpr Pose of_all_sizes{.scale = {largest, one_ulp, 8}, .translation = {0, 0, smallest}};
constexpr Object mapped_wall[] = {{.mesh = with_bits(14, 14), .material = mapped}, {.mesh = with_bits(-128, -128), .material = mapped},
                                  {.mesh = with_bits(127, 127), .material = mapped, .pose = of_all_sizes}, {.mesh = far_off(with_bits(0, 0)), .material = mapped}};
constexpr Light oblique[] = {{.position = {-7, -5, 5}, .space = Space::object}, {.position = {7, -5, 5}, .space = Space::object}};  // where chords are longest
constexpr Camera along_z{};
constexpr Object at_vertices[] = {{.mesh = with_bits(14, 14), .material = {.specular = white, .shininess = 1}},
                                  {.mesh = with_bits(14, 14), .material = {.specular = white, .reflection = Reflection::phong}},
                                  {.mesh = with_bits(14, 14), .material = {.specular = white, .shading = Shading::flat}, .pose = of_all_sizes}};
constexpr Camera local_camera{.eye = {1.5_q16, 0, 3}, .viewer = Viewer::local, .far_distance = smallest};
constexpr int bits_of(int8_t texcoord_bits, uint8_t slope_bits) {
    SlopeMap relief = relief_of_a_slope;
    relief.fraction_bits = slope_bits;
    Object o{.mesh = with_bits(14, texcoord_bits), .material = mapped};
    o.material.bump = &relief;
    const TextureLookup lookup(o, true);
    return lookup.bits * 100 + lookup.slope_bits;
}
TEST(TinyFrame, BitsOfMapsOutsideTheirRangeAreTheNearest) {
    EXPECT_AT_COMPILE_TIME(bits_of(-128, 0) == bits_of(0, 4) && bits_of(127, 255) == bits_of(15, 11) && bits_of(0, 4) != bits_of(15, 11));
}

constexpr Scene of_everything{.camera = local_camera, .lights = at_their_ends, .objects = mapped_wall, .background = blue},
    of_odd_normals{.camera = along_z, .lights = oblique, .objects = at_vertices, .background = blue};

TEST(TinyFrame, TheLargestAndTheSmallestNumbersAreDefined) {
    // That this compiles is the test: nothing overflows on the way to a pixel.
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return frame_of<of_the_largest_numbers, decltype(tier)>().count == 48; }));
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return frame_of<of_everything, decltype(tier)>().count == 48; }));
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return frame_of<of_odd_normals, decltype(tier)>().count == 48; }));
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return frame_of<of_the_smallest_numbers, decltype(tier)>().pixels[24].r == 255; }));
}

// --- Light that is missing ---

constexpr Light dim_and_bright[] = {ambient_light(grey), directional_light({0, 0, 1})};
constexpr Material matt{.ambient = red, .diffuse = white};
constexpr Object no_normals[] = {{.mesh = {.positions = quad.positions, .triangles = quad.triangles}, .material = matt, .pose = enlarged}};
constexpr Scene without_normals{.lights = dim_and_bright, .objects = no_normals, .background = blue};

TEST(TinyFrame, AMeshWithoutNormalsHasAmbientLightAlone) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<without_normals, decltype(tier)>(), rgb(0x800000)); }));
}

constexpr Object unlit_wall[] = {{.mesh = quad.mesh(), .material = {.ambient = white, .diffuse = rgb(0x204060), .specular = white, .emissive = white, .unlit = true}, .pose = enlarged}};
constexpr Scene unlit_among_lights{.lights = dim_and_bright, .objects = unlit_wall, .background = blue};

TEST(TinyFrame, AnUnlitObjectIsItsColourWhateverShines) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<unlit_among_lights, decltype(tier)>(), rgb(0x204060)); }));
}

constexpr Object unlit_by_nothing[] = {{.mesh = quad.mesh(), .material = {.diffuse = white, .specular = white}, .pose = enlarged}};
constexpr Scene without_light{.objects = unlit_by_nothing, .background = blue};

TEST(TinyFrame, WithoutLightALitObjectIsBlack) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<without_light, decltype(tier)>(), black); }));
}

// --- The smallest targets ---

constexpr Object white_wall[] = {{.mesh = quad.mesh(), .material = {.diffuse = white, .unlit = true}, .pose = enlarged}};
constexpr Scene white_scene{.objects = white_wall, .background = black};
constexpr Object lit_wall[] = {{.mesh = quad.mesh(), .material = {.diffuse = white}, .pose = enlarged}};
constexpr Scene lit_scene{.lights = headlight, .objects = lit_wall, .background = black};

TEST(TinyFrame, OnePixelIsATarget) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) { return shows_only(frame_of<wall_scene, decltype(tier), 1, 1>(), red); }));
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<wall_scene, mediump, 1, 1, Rgb565>(), red) && shows_only(frame_of<lit_scene, mediump, 1, 1, Rgb565>(), white));
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<wall_scene, mediump, 1, 1, Rgb565Swapped>(), red));
    EXPECT_AT_COMPILE_TIME(frame_of<white_scene, mediump, 1, 1, Gray8>().pixels[0] == 0xFF);
    EXPECT_AT_COMPILE_TIME(frame_of<white_scene, mediump, 1, 1, Gray4>().pixels[0] == 0xF0 && "the other half of the byte is background");
    EXPECT_AT_COMPILE_TIME(frame_of<white_scene, mediump, 1, 1, Mono1>().pixels[0] == 0x80);
    EXPECT_AT_COMPILE_TIME(frame_of<white_scene, mediump, 1, 1, Dithered<Mono1, bayer8>>().pixels[0] == 0x80);
}

constexpr Object wide_wall[] = {{.mesh = quad.mesh(), .material = plain, .pose = {.scale = {128, 128, 128}}}};
constexpr Scene wide_scene{.objects = wide_wall, .background = blue};

TEST(TinyFrame, OneRowOrOneColumnIsATarget) {
    EXPECT_AT_COMPILE_TIME(in_every_tier([](auto tier) {
        using Tier = decltype(tier);
        return shows_only(frame_of<wide_scene, Tier, 64, 1>(), red) && shows_only(frame_of<wide_scene, Tier, 1, 64>(), red);
    }));
}

TEST(TinyFrame, ReplayedVerticesDrawTheSameSmallestFrame) {
    EXPECT_AT_COMPILE_TIME(same_pixels(frame_of<lit_scene, mediump, 1, 1, Rgb888, VertexStore::replay>(), frame_of<lit_scene, mediump, 1, 1>()));
    EXPECT_AT_COMPILE_TIME(shows_only(frame_of<without_triangles, mediump, 2, 2, Rgb888, VertexStore::replay>(), blue));
}

}  // namespace
}  // namespace shade16::test
