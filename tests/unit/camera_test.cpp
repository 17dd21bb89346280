#include "shade16/scene/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace shade16 {
namespace {

constexpr double bound = 5e-9;  // of length and orthogonality, as look_rotation documents it

double dot_double(const Normal30& a, const Normal30& b) { return std::ldexp(static_cast<double>(dot(a, b)), -60); }

struct Errors {
    double length = 0, orthogonality = 0;
    void add(const Mat3& m) {
        for (int i = 0; i < 3; ++i) {
            length = std::fmax(length, std::fabs(std::sqrt(dot_double(m.row[i], m.row[i])) - 1));
            orthogonality = std::fmax(orthogonality, std::fabs(dot_double(m.row[i], m.row[(i + 1) % 3])));
        }
    }
    void check() const {
        EXPECT_LE(length, bound);
        EXPECT_LE(orthogonality, bound);
        ::testing::Test::RecordProperty("length", std::to_string(length * 1e9) + "e-9");
        ::testing::Test::RecordProperty("orthogonality", std::to_string(orthogonality * 1e9) + "e-9");
    }
};

bool is_right_handed(const Mat3& m) {
    const auto r = [&m](int i) { return raw(m.row[i]); };
    const auto minor = [](double p, double q, double s, double t) { return std::ldexp(p * q - s * t, -60); };
    const double z = minor(r(0).x, r(1).y, r(0).y, r(1).x) * r(2).z + minor(r(0).y, r(1).z, r(0).z, r(1).y) * r(2).x +
                     minor(r(0).z, r(1).x, r(0).x, r(1).z) * r(2).y;
    return std::fabs(std::ldexp(z, -30) - 1) < 1e-7;
}

TEST(Camera, LookRotationIsOrthonormal) {
    std::mt19937_64 random{19};
    Errors errors;
    for (int i = 0; i < 100'000; ++i) {
        const int shift = static_cast<int>(random() % 16);
        const auto coordinate = [&] { return Q16::from_raw(static_cast<int32_t>(random()) >> shift); };
        const Camera camera{.eye = {coordinate(), coordinate(), coordinate()},
                            .target = {coordinate(), coordinate(), coordinate()},
                            .up = {coordinate(), coordinate(), coordinate()}};
        const Mat3 m = look_rotation(camera);
        if (std::fabs(dot_double(normalize(camera.up), m.row[2])) > 0.999) continue;  // the tests below are for those
        errors.add(m);
        ASSERT_TRUE(is_right_handed(m));
    }
    errors.check();
}

TEST(Camera, LookRotationIsOrthonormalLookingAlmostStraightDown) {
    Errors errors;
    for (int32_t tilt = 1; tilt < 65536; tilt += 1 + tilt / 16)
        errors.add(look_rotation({.eye = {Q16::from_raw(tilt), 100, Q16::from_raw(-tilt / 3)}}));
    errors.check();
}

TEST(Camera, LooksFromTheEyeToTheTarget) {
    std::mt19937_64 random{20};
    for (int i = 0; i < 20'000; ++i) {
        const auto coordinate = [&] { return Q16::from_raw(static_cast<int32_t>(random()) >> 8); };
        const Camera camera{.eye = {coordinate(), coordinate(), coordinate()}, .target = {coordinate(), coordinate(), coordinate()}};
        const double x = camera.eye.x.raw - camera.target.x.raw, y = camera.eye.y.raw - camera.target.y.raw, z = camera.eye.z.raw - camera.target.z.raw;
        const double length = std::sqrt(x * x + y * y + z * z);
        const IVec3 back = raw(look_rotation(camera).row[2]);
        const double tolerance = std::ldexp(normalize_finely_max_error.milli / 1000.0, -30);
        ASSERT_NEAR(std::ldexp(back.x, -30), x / length, tolerance);
        ASSERT_NEAR(std::ldexp(back.y, -30), y / length, tolerance);
        ASSERT_NEAR(std::ldexp(back.z, -30), z / length, tolerance);
    }
}

TEST(Camera, TheClosestTargetStillGivesTheDirection) {
    for (const IVec3 d : {IVec3{1, 0, 0}, IVec3{0, 1, 0}, IVec3{3, 1, 0}, IVec3{-1, 2, -3}, IVec3{65, 19, -7}}) {
        const Camera camera{.eye = {Q16::from_raw(d.x), Q16::from_raw(d.y), Q16::from_raw(d.z)}};
        const IVec3 back = raw(look_rotation(camera).row[2]), exact = raw(normalize_finely(d));
        EXPECT_NEAR(back.x, exact.x, normalize_finely_max_error.milli / 1000.0) << d.x << ' ' << d.y << ' ' << d.z;
        EXPECT_NEAR(back.y, exact.y, normalize_finely_max_error.milli / 1000.0) << d.x << ' ' << d.y << ' ' << d.z;
        EXPECT_NEAR(back.z, exact.z, normalize_finely_max_error.milli / 1000.0) << d.x << ' ' << d.y << ' ' << d.z;
    }
}

TEST(Camera, TheFarthestTargetDoesNotOverflow) {
    constexpr Mat3 m = look_rotation({.eye = {32767, -32768, 32767}, .target = {-32768, 32767, -32768}});
    EXPECT_NEAR(std::ldexp(m.row[2].x.raw, -30), std::sqrt(1.0 / 3), 1e-4);
    EXPECT_NEAR(std::ldexp(m.row[2].y.raw, -30), -std::sqrt(1.0 / 3), 1e-4);
    Errors errors;
    errors.add(m);
    errors.check();
}

TEST(Camera, ATargetAtTheEyeLooksDownMinusZ) {
    static_assert(look_rotation({.eye = {5, 6, 7}, .target = {5, 6, 7}}).row[2] == Normal30{{}, {}, {Q30::one}});
    Errors errors;
    errors.add(look_rotation({.eye = {5, 6, 7}, .target = {5, 6, 7}}));
    errors.check();
}

TEST(Camera, AnUpAlongTheAxisIsReplaced) {
    Errors errors;
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}})
        for (const Vec3 up : {axis, -axis, Vec3{}}) {
            const Mat3 m = look_rotation({.eye = axis, .target = {}, .up = up});
            errors.add(m);
            EXPECT_TRUE(is_right_handed(m));
            EXPECT_NEAR(dot_double(m.row[2], normalize(axis)), 1, bound);
        }
    errors.check();
}

// The cross product of two almost parallel vectors has few digits unless it is exact.
TEST(Camera, LookRotationIsOrthonormalWhereUpIsAlmostTheAxis) {
    std::mt19937_64 random{21};
    Errors errors;
    for (int i = 0; i < 100'000; ++i) {
        const auto coordinate = [&] { return Q16::from_raw(static_cast<int32_t>(random()) >> 4); };
        Camera camera{.eye = {coordinate(), coordinate(), coordinate()}, .target = {coordinate(), coordinate(), coordinate()}};
        const int shift = 13 + static_cast<int>(random() % 19);
        const auto jitter = [&] { return Q16::from_raw(static_cast<int32_t>(random()) >> shift); };
        camera.up = camera.eye - camera.target + Vec3{jitter(), jitter(), jitter()};
        errors.add(look_rotation(camera));
    }
    errors.check();
}

TEST(Camera, AnUpAlongAnyAxisIsReplaced) {
    Errors errors;
    for (const Vec3 axis : {Vec3{1, 2, 3}, Vec3{-3, 0.1_q16, 5}, Vec3{100, 0.01_q16, 0.3_q16}})
        for (const Vec3 up : {axis, -axis, Vec3{}}) {
            const Mat3 m = look_rotation({.eye = axis, .target = {}, .up = up});
            errors.add(m);
            EXPECT_TRUE(is_right_handed(m));
            EXPECT_NEAR(dot_double(m.row[2], normalize(axis)), 1, bound);
        }
    errors.check();
}

TEST(Camera, OnlyAPerspectiveOneSeesLocally) {
    static_assert(Camera{.viewer = Viewer::local}.sees_locally());
    static_assert(!Camera{.projection = Projection::orthographic, .viewer = Viewer::local}.sees_locally());
    static_assert(!Camera{}.sees_locally());
}

}  // namespace
}  // namespace shade16
