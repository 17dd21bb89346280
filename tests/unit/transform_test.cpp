// The transform stage against double precision: random cameras, poses and meshes, from tiny to far away.
#include "shade16/pipeline/transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace shade16 {
namespace {

struct Double3 {
    double x, y, z;
};
Double3 as_double(Vec3 v) { return {v.x.raw / 65536.0, v.y.raw / 65536.0, v.z.raw / 65536.0}; }
Double3 operator+(Double3 a, Double3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Double3 operator-(Double3 a, Double3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(Double3 a, Double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Double3 cross(Double3 a, Double3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Double3 normalize(Double3 a) {
    const double length = std::sqrt(dot(a, a));
    return {a.x / length, a.y / length, a.z / length};
}

struct Projected {
    double x, y, z;  // 1/16 pixel, 1/16 pixel, units of a depth buffer
    double distance;
};

// What the stage computes, in the words of its documentation.
Projected project_exactly(const Camera& camera, Viewport viewport, const Pose& pose, const Mesh& mesh, Position16 p) {
    const double step = std::ldexp(1.0, -mesh.fraction_bits);
    const Double3 lattice = as_double(mesh.centre) + Double3{p.x * step, p.y * step, p.z * step}, scale = as_double(pose.scale);
    const Double3 object{lattice.x * scale.x, lattice.y * scale.y, lattice.z * scale.z};
    const auto turned = [&](int i) {
        const IVec3 r = raw(pose.rotation.row[i]);
        return std::ldexp(r.x * object.x + r.y * object.y + r.z * object.z, -30);
    };
    const Double3 world = Double3{turned(0), turned(1), turned(2)} + as_double(pose.translation);
    const Double3 eye = as_double(camera.eye), back = normalize(eye - as_double(camera.target));
    const Double3 right = normalize(cross(as_double(camera.up), back)), up = cross(back, right), view = world - eye;
    const double distance = -dot(view, back), near = camera.near_distance.raw / 65536.0, far = camera.far_distance.raw / 65536.0;
    const bool perspective = camera.projection == Projection::perspective;
    const double half_angle = std::ldexp(camera.fov_y.turns, -32) * std::numbers::pi;
    const double focal_px = perspective ? viewport.height / 2.0 / std::tan(half_angle) / distance : viewport.height / (camera.view_height.raw / 65536.0);
    const double depth = perspective ? far / (far - near) * (1 - near / distance) : (distance - near) / (far - near);
    return {16 * focal_px * dot(view, right), -16 * focal_px * dot(view, up), std::clamp(depth * last_depth, double{first_depth}, double{last_depth}), distance};
}

struct RandomScenes {
    std::mt19937_64 random{26};

    double uniform(double low, double high) { return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53); }
    double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    static Q16 q16(double v) { return Q16::from_raw(static_cast<int32_t>(std::lround(std::clamp(v, -32767.0, 32767.0) * 65536))); }
    Vec3 vector(double extent) { return {q16(uniform(-extent, extent)), q16(uniform(-extent, extent)), q16(uniform(-extent, extent))}; }
    Angle angle() { return {static_cast<uint32_t>(random())}; }

    Camera camera() {
        Camera c{.eye = vector(50), .target = vector(50)};
        c.projection = random() % 3 == 0 ? Projection::orthographic : Projection::perspective;
        c.fov_y = {static_cast<uint32_t>(std::ldexp(uniform(5, 150) / 360, 32))};
        c.view_height = q16(log_uniform(0.1, 1000));
        c.near_distance = q16(log_uniform(0.02, 5));
        c.far_distance = q16(c.near_distance.raw / 65536.0 * log_uniform(2, 5000));
        return c;
    }
    Viewport viewport() { return {static_cast<int32_t>(log_uniform(1, 2049)), static_cast<int32_t>(log_uniform(1, 2049))}; }
    Mesh mesh() {
        Mesh m;
        m.fraction_bits = static_cast<int8_t>(random() % 3 ? 14 : random() % 16);
        if (random() % 2) m.centre = vector(2);
        return m;
    }
    // An object of some size, roughly ahead of the camera.
    Pose pose(const Camera& c, const Mesh& m) {
        const double distance = log_uniform(0.05, 5000), scale = log_uniform(0.01, 1000) / (std::ldexp(32768.0, -m.fraction_bits) + 1);
        const Double3 eye = as_double(c.eye), ahead = normalize(as_double(c.target) - eye);
        const auto place = [&](double from, double direction) { return q16(from + direction * distance + uniform(-0.3, 0.3) * distance); };
        // Up to 1000 times thinner along an axis, but at least 2^-14: below, the scale itself has no digits.
        const auto stretched = [&](double least) { return max(q16(scale * log_uniform(least, 1)), Q16::from_raw(4)); };
        return {.rotation = rotate_x(angle()) * rotate_y(angle()) * rotate_z(angle()),
                .scale = {stretched(0.1), stretched(0.01), stretched(0.001)},
                .translation = {place(eye.x, ahead.x), place(eye.y, ahead.y), place(eye.z, ahead.z)}};
    }
    Position16 position() {
        const auto coordinate = [this] { return static_cast<int16_t>(random()); };
        return random() % 16 == 0 ? Position16{-32768, 32767, -32768} : Position16{coordinate(), coordinate(), coordinate()};
    }
};

// Rows are rounded to half a unit of 2^-14 over a lattice of 2^15 steps, offsets to half a unit, and the sum is rounded
// down: x, y and w err by up to 4.5 units. Where x is close to w both errors count, but in millions of vertices they never
// came to more than one's worst case.
constexpr double clip_error_units = 4.5;

TEST(Transform, ScreenAndDepthMatchDoublePrecision) {
    RandomScenes scenes;
    double worst_px16 = 0, worst_depth = 0, worst_excess = 0;
    long vertices = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Camera camera = scenes.camera();
        const Viewport viewport = scenes.viewport();
        const Mesh mesh = scenes.mesh();
        const Pose pose = scenes.pose(camera, mesh);
        const ViewTransform t = make_view_transform(make_view(camera, viewport), pose, mesh);
        for (int k = 0; k < 8; ++k) {
            const Position16 p = scenes.position();
            const ClipVertex v = to_clip(t, p);
            const Projected exact = project_exactly(camera, viewport, pose, mesh, p);
            if (outcode(t, v) != 0) continue;
            ScreenVertex<mediump> screen;
            project(t, v, screen);
            const double error = std::fmax(std::fabs(screen.x - exact.x), std::fabs(screen.y - exact.y)), depth_error = std::fabs(screen.z - exact.z);
            // What the common unit of the object leaves of w: a vertex far nearer than its object is large has few digits.
            const double unit_share = clip_error_units / v.w;
            ASSERT_LE(error, 0.51 + guard_extent * unit_share) << "w " << v.w;
            ASSERT_LE(depth_error, 1.05 + last_depth * unit_share) << "w " << v.w;
            worst_excess = std::fmax(worst_excess, (error - 0.51) * v.w / guard_extent);
            if (v.w < (1 << 19)) continue;
            worst_px16 = std::fmax(worst_px16, error);
            worst_depth = std::fmax(worst_depth, depth_error);
            ++vertices;
        }
    }
    RecordProperty("worst_px16", std::to_string(worst_px16));
    RecordProperty("worst_depth", std::to_string(worst_depth));
    RecordProperty("worst_clip_units", std::to_string(worst_excess));
    EXPECT_LE(worst_px16, 1);  // a sub-pixel
    EXPECT_LE(worst_depth, 2);
    EXPECT_GE(vertices, 200'000) << "most scenes should be seen";
}

// The object fills the frame or less: what a user would call an ordinary view.
TEST(Transform, OrdinaryViewsAreRoundedToTheNearestSubPixel) {
    RandomScenes scenes;
    double worst_px16 = 0, worst_depth = 0;
    for (int i = 0; i < 50'000; ++i) {
        const double distance = scenes.log_uniform(2, 50);
        const Camera camera{.eye = {0, 0, RandomScenes::q16(distance)}, .fov_y = {static_cast<uint32_t>(std::ldexp(scenes.uniform(20, 90) / 360, 32))},
                            .near_distance = 0.1_q16};
        const Viewport viewport{320, 240};
        const Mesh mesh;
        const Pose pose{.rotation = rotate_x(scenes.angle()) * rotate_y(scenes.angle()), .translation = scenes.vector(0.2)};
        const ViewTransform t = make_view_transform(make_view(camera, viewport), pose, mesh);
        const Position16 p{static_cast<int16_t>(static_cast<int16_t>(scenes.random()) / 2), static_cast<int16_t>(static_cast<int16_t>(scenes.random()) / 2), 0};
        const ClipVertex v = to_clip(t, p);
        if (outcode(t, v) != 0) continue;
        ScreenVertex<mediump> screen;
        project(t, v, screen);
        const Projected exact = project_exactly(camera, viewport, pose, mesh, p);
        worst_px16 = std::fmax(worst_px16, std::fmax(std::fabs(screen.x - exact.x), std::fabs(screen.y - exact.y)));
        worst_depth = std::fmax(worst_depth, std::fabs(screen.z - exact.z));
    }
    RecordProperty("worst_px16", std::to_string(worst_px16));
    RecordProperty("worst_depth", std::to_string(worst_depth));
    EXPECT_LE(worst_px16, 0.505);
    EXPECT_LE(worst_depth, 1.01);
}

// The divide alone, from the integers that it gets: its documented error.
TEST(Transform, TheDivideKeepsItsBound) {
    std::mt19937_64 random{27};
    double worst_px16 = 0, worst_depth = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        ViewTransform t;
        const int32_t w = (static_cast<int32_t>(random() & 0x7FFFFFFF) >> (1 + random() % 30)) | 1;
        const auto inside = [&random, w] { return static_cast<int32_t>(static_cast<int64_t>(random() % (2 * static_cast<uint64_t>(w) + 1)) - w); };
        t.near_depth = static_cast<int32_t>(random() % static_cast<uint64_t>(w)) + 1;
        t.depth_scale = last_depth << 16, t.depth_shift = 14;  // far away: depth last_depth * (1 - near / w)
        ClipVertex v{inside(), inside(), w, w};
        if (i % 8 == 0) v.x = w, v.y = -w;
        ScreenVertex<mediump> out;
        project(t, v, out);
        const auto exact = [&](int32_t c) { return static_cast<double>(c) / w * guard_extent; };
        worst_px16 = std::fmax(worst_px16, std::fmax(std::fabs(out.x - exact(v.x)), std::fabs(out.y - exact(v.y))));
        worst_depth = std::fmax(worst_depth, std::fabs(out.z - std::fmax(last_depth * (1 - static_cast<double>(t.near_depth) / w), first_depth)));
    }
    RecordProperty("worst_px16", std::to_string(worst_px16));
    RecordProperty("worst_depth", std::to_string(worst_depth));
    EXPECT_LE(worst_px16, 0.5 + std::ldexp(guard_extent, -24));
    EXPECT_LE(worst_depth, 1.001);
}

TEST(Transform, TheCentreOfTheViewIsTheCentreOfTheFrame) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera{.projection = projection};
        const ViewTransform t = make_view_transform(make_view(camera, {320, 240}), {}, {});
        ScreenVertex<mediump> out;
        project(t, to_clip(t, {}), out);
        EXPECT_EQ(out.x, 0);
        EXPECT_EQ(out.y, 0);
    }
}

TEST(Transform, XPointsRightAndYDown) {
    const ViewTransform t = make_view_transform(make_view({}, {320, 240}), {}, {});
    ScreenVertex<mediump> out;
    project(t, to_clip(t, {1000, 1000, 0}), out);
    EXPECT_GT(out.x, 0);
    EXPECT_LT(out.y, 0);
}

TEST(Transform, DepthRunsFromNearToFar) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera{.eye = {}, .target = {0, 0, -1}, .projection = projection, .near_distance = 2, .far_distance = 50};
        const View3 view = make_view(camera, {320, 240});
        const auto depth_at = [&](Q16 distance) {
            const ViewTransform t = make_view_transform(view, {.translation = {0, 0, -distance}}, {});
            ScreenVertex<mediump> out;
            project(t, to_clip(t, {}), out);
            return int{out.z};
        };
        EXPECT_EQ(depth_at(2), static_cast<int>(first_depth));
        EXPECT_GE(depth_at(50), static_cast<int>(last_depth) - 1);
        EXPECT_GE(depth_at(5000), static_cast<int>(last_depth) - 1) << "farther geometry keeps the last depth value";
        int previous = -1;
        for (int32_t raw = 2 * 65536; raw < 50 * 65536; raw += 9973) {
            const int depth = depth_at(Q16::from_raw(raw));
            ASSERT_GE(depth, previous);
            previous = depth;
        }
    }
}

TEST(Transform, OutcodesNameThePlanes) {
    ViewTransform t;
    t.near_depth = 100;
    const auto code = [&t](int32_t x, int32_t y, int32_t depth) { return outcode(t, {x, y, depth, depth}); };
    EXPECT_EQ(code(0, 0, 100), 0);
    EXPECT_EQ(code(0, 0, 99), outside_near);
    EXPECT_EQ(code(100, -100, 100), 0) << "the planes themselves are inside";
    EXPECT_EQ(code(101, 0, 100), outside_right);
    EXPECT_EQ(code(-101, 0, 100), outside_left);
    EXPECT_EQ(code(0, 101, 100), outside_bottom);
    EXPECT_EQ(code(0, -101, 100), outside_top);
    EXPECT_EQ(code(-500, 500, 100), outside_left | outside_bottom);
    EXPECT_EQ(code(0, 0, -100), outside_any) << "behind the eye every plane is crossed";
}

// Values outside a camera's domain must draw something rather than trap: the sanitizers watch.
TEST(Transform, TotalForAnyCameraAndPose) {
    std::mt19937_64 random{28};
    for (int i = 0; i < 50'000; ++i) {
        const auto any = [&random, i] { return Q16::from_raw(static_cast<int32_t>(random()) >> (i % 32)); };
        const auto any_vector = [&any] { return Vec3{any(), any(), any()}; };
        const Camera camera{.eye = any_vector(), .target = any_vector(), .up = any_vector(),
                            .projection = i & 1 ? Projection::perspective : Projection::orthographic, .fov_y = {static_cast<uint32_t>(random())},
                            .view_height = any(), .near_distance = any(), .far_distance = any()};
        Mesh mesh;
        mesh.centre = any_vector();
        mesh.fraction_bits = static_cast<int8_t>(random() % 31);
        const Pose pose{.rotation = rotate_x({static_cast<uint32_t>(random())}), .scale = any_vector(), .translation = any_vector()};
        const ViewTransform t = make_view_transform(make_view(camera, {1 + static_cast<int32_t>(random() % 2048), 1 + static_cast<int32_t>(random() % 2048)}), pose, mesh);
        for (const Position16 p : {Position16{-32768, -32768, -32768}, Position16{32767, -32768, 32767}, Position16{}}) {
            const ClipVertex v = to_clip(t, p);
            if (outcode(t, v) != 0) continue;
            ScreenVertex<mediump> out;
            project(t, v, out);
            ASSERT_LE(std::abs(out.x), guard_extent);
            ASSERT_LE(std::abs(out.y), guard_extent);
            ASSERT_GE(out.z, first_depth);
            ASSERT_LE(out.z, last_depth);
        }
    }
}

}  // namespace
}  // namespace shade16
