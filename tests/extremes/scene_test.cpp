// Scenes at their ends, drawn as the simulator draws them: the largest frames and meshes, walls across the guard band and the near plane,
// worlds of any scale.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/report/compare.hpp"

namespace shade16::host {
namespace {

constexpr Q16 one_ulp = Q16::from_raw(1);
constexpr Material plain{.diffuse = white, .unlit = true};

// --- Walls that fill every pixel: one term, so that these pipelines compile quickly ---

constexpr Needs unlit_needs{.perspective = true, .orthographic = true, .depth = true, .unlit = true, .gouraud = true};

template <class Format = Rgb565>
std::vector<typename Format::Pixel> unlit_frame(const Scene& scene, Viewport viewport, int rows = 0) {
    RuntimeRenderer<mediump, channels_of_format<Format>, unlit_needs> renderer(scene);
    renderer.begin({}, viewport);
    return renderer.template draw<Format>(rows);
}
template <class Format = Rgb565>
::testing::AssertionResult fills(const Scene& scene, Viewport viewport) {
    const auto pixels = unlit_frame<Format>(scene, viewport);
    const auto missing = std::count_if(pixels.begin(), pixels.end(), [](auto p) { return p != nearest_pixel<Format>(white); });
    if (missing == 0) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << missing << " of " << pixels.size() << " pixels are not white";
}

Scene wall_scene(const Object& wall, const Camera& camera = {}) { return {.camera = camera, .objects = {&wall, 1}, .background = rgb(0x0000FF)}; }

TEST(SceneAtItsEnds, TheLargestTargetsAreFilled) {
    const Object wall{.mesh = quad.mesh(), .material = plain, .pose = {.scale = {8192, 8192, 8192}}};
    for (const Viewport viewport : {Viewport{2048, 2048}, Viewport{2048, 1}, Viewport{1, 2048}, Viewport{2047, 3}, Viewport{3, 2047}})
        EXPECT_TRUE(fills(wall_scene(wall), viewport)) << viewport.width << " x " << viewport.height;
}

// A wall whose corners lie anywhere, from inside the frame's neighbourhood across the edge of the guard band to the end of the world;
// about the edge, where clipping begins, by steps of one ulp.
TEST(SceneAtItsEnds, AWallAcrossTheGuardBandHasNoGaps) {
    constexpr Viewport viewport{40, 30};
    // The wall is 3 units away and the frame 30 pixels high: a unit is 12.07 pixels, so that the guard band ends at 169.6 units.
    const auto fills_at = [&](Q16 scale) {
        const Object wall{.mesh = quad.mesh(), .material = plain, .pose = {.scale = {scale, scale, scale}}};
        return fills(wall_scene(wall), viewport);
    };
    for (int32_t raw = 2 * 65536; raw < INT32_MAX / 2; raw += raw / 50) ASSERT_TRUE(fills_at(Q16::from_raw(raw))) << raw;
    ASSERT_TRUE(fills_at(Q16::from_raw(INT32_MAX)));
    for (int32_t raw = 11'113'000; raw < 11'123'000; raw += 7) ASSERT_TRUE(fills_at(Q16::from_raw(raw))) << raw;
}

// The floor passes below the eye, from far behind it to the horizon: half of the frame, whatever the near plane is. An object's
// numbers have 29 bits from its farthest corner on; a floor of 1000 leaves the height above it 12 bits.
TEST(SceneAtItsEnds, AFloorThroughTheNearPlaneHasNoGaps) {
    constexpr Viewport viewport{32, 24};
    const Object floor{.mesh = quad.mesh(), .material = plain, .pose = {.rotation = rotate_x(-90_deg), .scale = {1000, 1000, 1000}}};
    constexpr Q16 near_planes[] = {one_ulp, 0.001_q16, 0.1_q16, 1, 3}, heights[] = {0.1_q16, 1, 7}, aside = 0.3_q16, back = 0.7_q16, ahead = -1;
    for (const Q16 near : near_planes)
        for (const Q16 height : heights) {
            const Camera camera{.eye = {aside, height, back}, .target = {aside, height, ahead}, .near_distance = near, .far_distance = 2000};
            const auto pixels = unlit_frame(wall_scene(floor, camera), viewport);
            // Rows that look down far enough to meet the floor beyond the near plane.
            for (int y = 0; y < viewport.height; ++y) {
                const double slope = (y + 0.5 - viewport.height / 2.0) / (viewport.height / 2.0) * 0.41421356, distance = slope > 0 ? height.raw / 65536.0 / slope : -1;
                if (distance > 0 && distance < near.raw / 65536.0 * 1.01 + 1e-3) continue;  // before the near plane, or beside its edge
                if (distance > 900) continue;                                                // beside the floor's far edge
                for (int x = 0; x < viewport.width; ++x)
                    ASSERT_EQ(pixels[static_cast<std::size_t>(y * viewport.width + x)], nearest_pixel<Rgb565>(distance > 0 ? white : rgb(0x0000FF)))
                        << "column " << x << ", row " << y << ", near " << near.raw << ", height " << height.raw;
            }
        }
}

// 65,535 vertices, the most that 16-bit indices name without their last value: 257 rows of 255, the last one used.
TEST(SceneAtItsEnds, AMeshOfAllVerticesIsDrawn) {
    constexpr int columns = 255, rows = 257;
    std::vector<Position16> positions;
    std::vector<Triangle> triangles;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            positions.push_back({static_cast<int16_t>(-32768 + 65535 * j / (columns - 1)), static_cast<int16_t>(-32768 + 65535 * i / (rows - 1)), 0});
    const auto at = [](int i, int j) { return static_cast<uint16_t>(i * columns + j); };
    for (int i = 0; i + 1 < rows; ++i)
        for (int j = 0; j + 1 < columns; ++j) {
            triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    ASSERT_EQ(positions.size(), max_mesh_vertices);
    ASSERT_EQ(triangles.back().b, 65534);
    const Object wall{.mesh = {.positions = {positions.data(), max_mesh_vertices}, .triangles = {triangles.data(), static_cast<uint32_t>(triangles.size())}}, .material = plain};
    EXPECT_TRUE(fills(wall_scene(wall), {160, 120}));
}

// Bands, dithered, as low as one row: thresholds are those of the frame and not of the band.
TEST(SceneAtItsEnds, BandsOfOneRowAreTheFrame) {
    const Object wall{.mesh = quad.mesh(), .material = {.diffuse = rgb(0x5A7B3C), .unlit = true}};
    const Scene scene = wall_scene(wall);
    constexpr Viewport viewport{37, 29};
    for (const int rows : {1, 2, 28}) {
        EXPECT_EQ(unlit_frame<Rgb565>(scene, viewport, rows), unlit_frame<Rgb565>(scene, viewport));
        EXPECT_EQ((unlit_frame<Dithered<Mono1, bayer8>>(scene, viewport, rows)), (unlit_frame<Dithered<Mono1, bayer8>>(scene, viewport)));
    }
}

// --- Worlds of any scale ---

// Everything times a power of two is the same picture: numbers carry their exponents. The smallest has 12 bits left, all of them dyadic.
Scene scaled_world(Object& object, Light& sun, int log2) {
    const auto scaled = [log2](Q16 v) { return Q16::from_raw(log2 >= 0 ? v.raw << log2 : v.raw >> -log2); };
    const auto scaled_vector = [&](Vec3 v) { return Vec3{scaled(v.x), scaled(v.y), scaled(v.z)}; };
    object = {.mesh = sphere<16, 8>.mesh(), .material = {.diffuse = rgb(0xC08040), .specular = white, .shininess = 20}, .pose = {.rotation = rotate_y(20_deg), .scale = {scaled(1), scaled(1), scaled(1)}}};
    sun = directional_light({1, 2, 3});
    return {.camera = {.eye = scaled_vector({0.5_q16, 1, 3}), .near_distance = scaled(1), .far_distance = scaled(64)}, .lights = {&sun, 1}, .objects = {&object, 1}};
}
constexpr Needs lit_needs{.perspective = true, .depth = true, .lit = true, .gouraud = true, .diffuse = true, .specular = true, .halfway = true, .directional = true};

TEST(SceneAtItsEnds, AWorldTimesAPowerOfTwoIsTheSamePicture) {
    const auto frame = [](int log2) {
        Object object;
        Light sun;
        const Scene scene = scaled_world(object, sun, log2);
        RuntimeRenderer<mediump, Channels::rgb, lit_needs> renderer(scene);
        renderer.begin({}, {64, 48});
        return renderer.draw<Rgb888>();
    };
    const auto one = frame(0);
    EXPECT_GT(std::count_if(one.begin(), one.end(), [](auto p) { return p.r > 0; }), 500);
    for (int log2 = -12; log2 <= 8; ++log2) EXPECT_EQ(frame(log2), one) << "2^" << log2;
}

// The same for a mesh's own lattice, from whole steps to the finest.
TEST(SceneAtItsEnds, TheLatticesScaleIsThePosesScale) {
    const auto frame = [](int8_t fraction_bits, Q16 scale) {
        Mesh mesh = cube.mesh();
        mesh.fraction_bits = fraction_bits;
        const Object object{.mesh = mesh, .material = plain, .pose = {.rotation = rotate_y(30_deg), .scale = {scale, scale, scale}}};
        return unlit_frame(wall_scene(object), {48, 36});
    };
    const auto one = frame(14, 1);
    EXPECT_EQ(frame(0, Q16::from_raw(4)), one) << "2^14 steps of 2^0, times 2^-14";
    EXPECT_EQ(frame(28, 16384), one) << "2^14 steps of 2^-28, times 2^14";
}

// --- Against double precision: vertices and pixels within the tier's promise ---

void expect_kept(const Scene& scene, const char* what, std::size_t least_pixels = 100) {
    const reference::Scene exact = reference::value(scene);
    Comparison of_lowp, of_mediump, of_highp;
    compare_frame<lowp>(of_lowp, exact, exact, {}, {64, 48});
    compare_frame<mediump>(of_mediump, exact, exact, {}, {64, 48});
    compare_frame<highp>(of_highp, exact, exact, {}, {64, 48});
    for (const Comparison* c : {&of_lowp, &of_mediump, &of_highp}) {
        EXPECT_TRUE(c->vertices.holds()) << what << ": a vertex takes " << c->vertices.largest_of_bound << " of its bound";
        EXPECT_TRUE(c->pixels.holds()) << what << ": a pixel takes " << c->pixels.largest_of_bound << " of its bound";
        EXPECT_GE(c->pixels.count, least_pixels) << what;
    }
}

constexpr Material brass{.diffuse = rgb(0xC08040), .specular = rgb(0xFFE0A0), .shininess = 30};

TEST(SceneAtItsEnds, ALampInsideAndOnASurfaceKeepsThePromise) {
    const Object torus_object{.mesh = torus<24, 12>.mesh(), .material = brass};
    // At a vertex of the torus, a little above it, in its tube and in its hole.
    const Vec3 at_vertex{1.4_q16, 0, 0};
    for (const Vec3 place : {at_vertex, Vec3{1.4_q16, 0, one_ulp}, Vec3{1.41_q16, 0, 0.01_q16}, Vec3{1, 0, 0}, Vec3{}}) {
        const Light lights[] = {point_light(place), directional_light({0, 1, 2}, rgb(0x404040))};
        expect_kept({.camera = {.eye = {0, 2, 3}}, .lights = lights, .objects = {&torus_object, 1}}, "a lamp at the surface");
    }
}

TEST(SceneAtItsEnds, ObjectsOfOneToAThousandKeepThePromise) {
    // A speck before a planet, whose scales are a million apart.
    Object objects[] = {{.mesh = sphere<16, 8>.mesh(), .material = brass, .pose = {.scale = {0.03_q16, 0.03_q16, 0.03_q16}, .translation = {0, 0, 2.9_q16}}},
                        {.mesh = sphere<16, 8>.mesh(), .material = brass, .pose = {.scale = {1000, 1000, 1000}, .translation = {0, 0, -3000}}},
                        {.mesh = cube.mesh(), .material = brass, .pose = {.rotation = rotate_z(30_deg), .scale = {1000, 1, 1}, .translation = {0, -2, -3}}}};
    const Light lights[] = {directional_light({1, 1, 1}), point_light({0.1_q16, 0.1_q16, 3})};
    expect_kept({.camera = {.near_distance = 0.05_q16, .far_distance = 5000}, .lights = lights, .objects = objects}, "1 to 1000");
}

TEST(SceneAtItsEnds, ACameraInsideAModelKeepsThePromise) {
    // Inside the tube of a torus that is turned inside out, and outside its faces.
    Mesh inner = torus<24, 12>.mesh();
    std::vector<Triangle> turned;
    for (const Triangle& t : inner.triangles) turned.push_back({t.c, t.b, t.a});
    inner.triangles = {turned.data(), static_cast<uint32_t>(turned.size())};
    const Object tube{.mesh = inner, .material = brass};
    // Faces are seen from inside, but their normals point out: lamps stand outside, too.
    const Light lights[] = {point_light({1, 0, 2}), point_light({3, 1, 0})};
    for (const Viewer viewer : {Viewer::infinite, Viewer::local})
        expect_kept({.camera = {.eye = {1, 0, 0}, .target = {1, 1, 0}, .up = {0, 0, 1}, .viewer = viewer, .fov_y = 90_deg, .near_distance = 0.02_q16}, .lights = lights, .objects = {&tube, 1}},
                    "inside a tube");
}

TEST(SceneAtItsEnds, SixtyFourLightsOfTwoKeepThePromise) {
    Material dark = brass;
    dark.diffuse = {{900}, {500}, {200}}, dark.specular = {{400}, {400}, {400}};
    const Object object{.mesh = sphere<16, 8>.mesh(), .material = dark};
    std::vector<Light> lights;
    for (int i = 0; i < 64; ++i) {
        const SinCos turn = sincos(Angle{static_cast<uint32_t>(i) << 26}), tilt = sincos(Angle{static_cast<uint32_t>(i) << 28});
        const auto q = [](Q30 v) { return Q16::from_raw(v.raw >> 13); };  // at 2 units
        lights.push_back(i % 2 ? point_light({q(turn.cos), q(turn.sin), q(tilt.cos)}, white, 2) : directional_light({q(turn.cos), q(tilt.sin), q(turn.sin)}, white, 2));
    }
    expect_kept({.lights = {lights.data(), 64}, .objects = {&object, 1}}, "64 lights");
}

}  // namespace
}  // namespace shade16::host
