#include "shade16/num/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace shade16 {
namespace {

constexpr double one = Q30::one, turn = 4294967296.0;

Q30 q30(double x) { return {static_cast<int32_t>(std::llround(x * one))}; }

struct Vector {
    double x = 0, y = 0, z = 0;
};
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator*(double k, Vector a) { return {k * a.x, k * a.y, k * a.z}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector unit(Vector a) { return 1 / std::sqrt(dot(a, a)) * a; }
Normal30 normal(Vector a) { return {q30(a.x), q30(a.y), q30(a.z)}; }
Vector vector(const Normal30& n) { return {n.x.raw / one, n.y.raw / one, n.z.raw / one}; }
Vector vector(IVec3 n) { return {n.x / one, n.y / one, n.z / one}; }

TEST(Arc, TheArctangentIsWithinItsBound) {
    double worst = 0;
    for (int i = 0; i <= 400'000; ++i) {
        const double angle = std::numbers::pi * i / 400'000;
        const Q30 y = q30(std::sin(angle)), x = q30(std::cos(angle));
        const double exact = std::atan2(y.raw, x.raw) / (2 * std::numbers::pi);
        worst = std::fmax(worst, std::fabs(arctangent(y, x).turns / turn - exact));
    }
    RecordProperty("worst_log2", std::to_string(std::log2(worst)));
    EXPECT_LE(worst, std::ldexp(arctangent_max_error.milli / 1000.0, -32));
    EXPECT_EQ(arctangent({0}, {0}), Angle{});
    EXPECT_EQ(arctangent({0}, {Q30::one}), Angle{});
    EXPECT_NEAR(arctangent({0}, {-Q30::one}).turns / turn, 0.5, 1e-9);
}

// Errors grow where the plane is hardly there: as 1 / sin(angle).
TEST(Arc, FollowsTheGreatCircle) {
    std::mt19937_64 random(11);
    const auto any = [&] { return static_cast<double>(static_cast<int64_t>(random())) / 9.3e18; };
    double worst = 0;
    for (int i = 0; i < 300'000; ++i) {
        const Vector u = unit({any(), any(), any()});
        const double nearness = std::pow(10, -static_cast<double>(random() % 7));
        const Vector v = i % 3 ? unit({any(), any(), any()}) : unit((i % 2 ? 1.0 : -1.0) * u + nearness * Vector{any(), any(), any()});
        const Normal30 a = normal(u), b = normal(v);
        const auto t = static_cast<int32_t>(random() % (Q30::one + 1u));
        const Vector p = vector(a), q = vector(b), rest = q + -dot(p, q) * p;
        const double sine = std::sqrt(dot(rest, rest)), angle = std::atan2(sine, dot(p, q));
        const Vector got = vector(Arc(a, b).at(t));
        EXPECT_NEAR(dot(got, got), 1, 2e-8);
        if (sine < 1e-6) continue;
        const Vector exact = std::cos(t / one * angle) * p + std::sin(t / one * angle) / sine * rest;
        const Vector error = got + -1.0 * exact;
        // A short arc is as exact as its ends; near half a turn the plane itself is uncertain.
        worst = std::fmax(worst, std::sqrt(dot(error, error)) * (angle < 1 ? 1 : sine));
    }
    RecordProperty("worst_ulp", std::to_string(worst * one));
    EXPECT_LE(worst, arc_max_error.milli / 1000.0 / one);
}

TEST(Arc, OppositeNormalsTurnByWayOfTheAxisFarthestFromThem) {
    const Normal30 up{{0}, {Q30::one}, {0}}, down{{0}, {-Q30::one}, {0}};
    const Vector middle = vector(Arc(up, down).at(Q30::one / 2));
    EXPECT_NEAR(middle.x, 1, 1e-8);
    EXPECT_NEAR(middle.y, 0, 1e-8);
    const Vector end = vector(Arc(up, down).at(Q30::one));
    EXPECT_NEAR(end.y, -1, 1e-8);
}

// Rounded unit vectors are a little too short or too long: what remains of b off a then lies along a, and makes no plane.
TEST(Arc, OppositeNormalsMayErrInTheirLengths) {
    for (int32_t error = -3; error <= 3; ++error) {
        const Normal30 a{{-Q30::one + error}, {0}, {0}}, b{{Q30::one}, {0}, {0}};
        const Vector middle = vector(Arc(a, b).at(Q30::one / 2));
        EXPECT_NEAR(dot(middle, middle), 1, 2e-8) << error;
        EXPECT_NEAR(middle.x, 0, 1e-8) << error;
        const Normal30 equal{{Q30::one + error}, {0}, {0}};
        const Vector near = vector(Arc(equal, b).at(Q30::one / 2));
        EXPECT_NEAR(near.x, 1, 1e-8) << error;
    }
}

TEST(Arc, EqualAndZeroNormalsMakeAPoint) {
    const Normal30 n = normal(unit({1, 2, 3}));
    for (const int32_t t : {0, 1, Q30::one / 2, int32_t{Q30::one}}) {
        const IVec3 same = Arc(n, n).at(t);
        EXPECT_NEAR(same.x, n.x.raw, 2);
        EXPECT_NEAR(same.z, n.z.raw, 2);
        EXPECT_EQ(Arc({}, {}).at(t), IVec3{});
    }
}

}  // namespace
}  // namespace shade16
