// Ranges, falloff and cones (pipeline/lamp.hpp): what must hold exactly, and their formulas. The promises on their error are
// the accuracy tests'.
#include "shade16/pipeline/lamp.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "unit/lit_point.hpp"

namespace shade16 {
namespace {

template <class Tier>
class Lamp : public ::testing::Test {
protected:
    /// The brightness of one lamp at a point of a white surface.
    static double at(const Light& light, Normal14 normal = facing, Position16 position = {}) {
        const Material matt{.diffuse = white};
        return static_cast<double>(lit<Tier>({.material = matt, .lights = {light}}, normal, position).r) / Accumulator::one;
    }
    /// Of 16-bit products, cosines and factors, and of the length of the light's direction.
    static constexpr double rounding() {
        using A = Arithmetic<Tier>;
        return 4.0 / 65536 + (A::wide ? 0 : (A::rsqrt_bits == 6 ? rsqrt_49_max_error : rsqrt_97_max_error) * 0x1p-32);
    }
};
using Tiers = ::testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(Lamp, Tiers);

constexpr Vec3 ahead{0, 0, 2}, down{0, 0, -1}, close{0, 0, 0.5_q16};
constexpr Scaled very_strong = 4'000'000'000_scaled;

Light lamp_at(Vec3 place, Q16 power, Q16 range = 0) {
    Light light = point_light(place);
    light.attenuation.power = power, light.range = range;
    return light;
}
// In place of the literals, which Clang 14 does not evaluate while it compiles a template.
Angle degrees(double d) { return {static_cast<uint32_t>(std::llround(d / 360 * 0x1p32))}; }
Q16 q16(double v) { return Q16::from_raw(static_cast<int32_t>(std::lround(v * 65536))); }

TYPED_TEST(Lamp, FallsOffByAPowerOfTheDistance) {
    EXPECT_NEAR(this->at(lamp_at(ahead, 1)), 1 / 2.0, this->rounding());
    EXPECT_NEAR(this->at(lamp_at(ahead, q16(0.5))), 1 / std::sqrt(2.0), this->rounding());
    EXPECT_NEAR(this->at(lamp_at(ahead, q16(1.9))), std::pow(2, -1.9), this->rounding());
    EXPECT_NEAR(this->at(lamp_at(ahead, 5)), 1 / 4.0, this->rounding()) << "clamped to 2";
    EXPECT_NEAR(this->at(lamp_at(ahead, -1)), 1, this->rounding()) << "negative ones count as 0";
    EXPECT_NEAR(this->at(lamp_at(close, 1)), 2, 2 * this->rounding()) << "a factor above 1";
    Light both = lamp_at(ahead, 1);
    both.attenuation.linear = 1;
    EXPECT_NEAR(this->at(both), 1 / 3.0 / 2, this->rounding());
}

TYPED_TEST(Lamp, FadesTowardsItsRange) {
    EXPECT_NEAR(this->at(lamp_at(ahead, 0, 4)), std::pow(1 - 4.0 / 16, 2), this->rounding());
    EXPECT_NEAR(this->at(lamp_at(ahead, 1, 4)), std::pow(1 - 4.0 / 16, 2) / 2, this->rounding());
    EXPECT_NEAR(this->at(lamp_at(ahead, 0, 2000)), 1, this->rounding());
    EXPECT_EQ(this->at(lamp_at(ahead, 0, 0)), this->at(point_light(ahead))) << "0 is no range";
    EXPECT_EQ(this->at(lamp_at(ahead, 0, -1)), this->at(point_light(ahead)));
}

// Whole distances in any direction, at any scale of the world and of the object. A lamp's place is known to 2^-12 of a lattice step, so
// that very strong lamps must stand farther off than weak ones.
TYPED_TEST(Lamp, EndsExactlyAtItsRange) {
    const int whole[][4] = {{0, 0, 1, 1}, {1, 2, 2, 3}, {2, 3, 6, 7}, {4, 4, 7, 9}, {1, 4, 8, 9}, {2, 6, 9, 11}, {3, 4, 12, 13}, {2, 5, 14, 15}};
    for (const auto& w : whole)
        for (const Q16 scale : {Q16{1}, q16(0.3), Q16{7}})
            for (int shift = 5; shift < 26; ++shift) {
                const auto c = [shift](int n) { return Q16::from_raw(n << shift); };
                Setting s{.material = {.diffuse = white, .specular = white}, .lights = {lamp_at({c(w[0]), c(w[1]), c(w[2])}, 0, c(w[3]))}};
                s.mesh.fraction_bits = 14;
                s.pose.scale = {scale, scale, scale};
                if (shift > 18) s.lights[0].intensity = very_strong;
                ASSERT_TRUE(is_black(lit<TypeParam>(s))) << w[3] << " << " << shift;
                s.lights[0].range = Q16::from_raw((w[3] << shift) / 4);
                ASSERT_TRUE(is_black(lit<TypeParam>(s)));
                s.lights[0].range = Q16::from_raw((w[3] << shift) + (w[3] << shift >> 4));
                ASSERT_FALSE(is_black(lit<TypeParam>(s))) << w[3] << " << " << shift;
            }
}

// smoothstep(cos outer, cos inner, cos angle) cos^exponent, at an angle from the axis.
double cone(double angle, double inner, double outer, double exponent) {
    const auto c = [](double d) { return std::cos(d * std::numbers::pi / 180); };
    const double t = std::fmin(std::fmax((c(angle) - c(outer)) / (c(inner) - c(outer)), 0), 1);
    return t * t * (3 - 2 * t) * std::pow(c(angle), exponent);
}
Light spot_at_angle(double angle, double inner, double outer, double exponent = 0) {
    const double a = angle * std::numbers::pi / 180;
    return spot_light(ahead, {{q16(100 * std::sin(a)), 0, q16(-100 * std::cos(a))}, degrees(inner), degrees(outer), q16(exponent)});
}

TYPED_TEST(Lamp, ShinesInACone) {
    for (const double angle : {0.0, 5.0, 12.0, 17.5, 24.0, 29.0})
        for (const double exponent : {0.0, 1.0, 4.5, 128.0})
            EXPECT_NEAR(this->at(spot_at_angle(angle, 10, 30, exponent)), cone(angle, 10, 30, exponent), this->rounding()) << angle << ' ' << exponent;
    EXPECT_NEAR(this->at(spot_at_angle(1.5, 1, 2)), cone(1.5, 1, 2, 0), this->rounding() + 1e-4 /* of the direction's 16 bits */);
    EXPECT_NEAR(this->at(spot_at_angle(89, 0, 90)), cone(89, 0, 90, 0), this->rounding());
    EXPECT_NEAR(this->at(spot_at_angle(89, 0, 170)), cone(89, 0, 90, 0), this->rounding()) << "outer is clamped to 90 degrees";
    EXPECT_NEAR(this->at(spot_at_angle(40, 60, 50)), 1, this->rounding()) << "inner is clamped to outer";
    EXPECT_EQ(this->at(spot_at_angle(51, 60, 50)), 0);
    EXPECT_EQ(this->at(spot_at_angle(170, 0, 90)), 0) << "behind it";
    for (const double angle : {0.0, 1.0}) EXPECT_EQ(this->at(spot_at_angle(angle, 0, 0)), 0) << "a cone of 0 lights nothing, at " << angle;
    EXPECT_EQ(this->at(spot_light(ahead, {.direction = {0, 0, 0}})), 0) << "an axis without a direction lights nothing";
}

// Random cones at the axis, at any place; the point moves across the edge.
TYPED_TEST(Lamp, IsExactlyNothingOutsideTheCone) {
    std::mt19937_64 random{51};
    const auto uniform = [&random](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    int beside = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double outer = std::exp(uniform(std::log(0.2), std::log(60.0))), distance = std::exp(uniform(std::log(1.0), std::log(400.0)));
        const double tilt = uniform(-20, 20) * std::numbers::pi / 180;
        const Vec3 place{q16(distance * std::sin(tilt)), 0, q16(distance * std::cos(tilt))};
        const double beyond = outer + (i % 2 ? std::exp(uniform(std::log(1e-5), 0)) : -std::exp(uniform(std::log(1e-3), std::log(0.1))));
        const double a = tilt + beyond * std::numbers::pi / 180;
        Light light = spot_light(place, {{q16(-8000 * std::sin(a)), 0, q16(-8000 * std::cos(a))}, {}, degrees(outer), 0}, white, very_strong);
        const double px = place.x.raw, pz = place.z.raw, ax = light.spot.direction.x.raw, az = light.spot.direction.z.raw;
        const double angle = std::fabs(std::atan2(px * az - pz * ax, -px * ax - pz * az)) * 180 / std::numbers::pi;
        if (std::fabs(angle - outer) < 5e-6) continue;  // as fine as the lattice of the lamp's place and of its axis
        beside += std::fabs(angle - outer) < 1e-4;
        if (angle > outer) ASSERT_EQ(this->at(light), 0) << angle << " outside " << outer;
        else ASSERT_GT(this->at(light), 0) << angle << " inside " << outer;
    }
    EXPECT_GT(beside, 100);
}

// One step of the lattice at a time across the whole cone: no step of the light is larger than the steepest place of the formula.
TYPED_TEST(Lamp, IsContinuousAcrossTheCone) {
    const Light light = spot_light(ahead, {down, degrees(4), degrees(5), 0});
    const double steepest = 1.5 * (1 / 2.0) / (1 * std::numbers::pi / 180) * 0x1p-14 * 1.1;  // d(angle) = dx / 2, slopes of cos alike
    double previous = this->at(light), largest = 0;
    for (int x = 0; x < 4000; ++x) {
        const double now = this->at(light, facing, {static_cast<int16_t>(x), 0, 0});
        largest = std::fmax(largest, std::fabs(now - previous));
        previous = now;
    }
    EXPECT_GT(this->at(light), 0.9) << "inside, it is bright";
    EXPECT_EQ(previous, 0);
    EXPECT_LE(largest, steepest + this->rounding());
    EXPECT_GE(largest, steepest / 2) << "a slope that is hardly there is no test of steps";
}

TYPED_TEST(Lamp, SpacesAgreeWhereTheyCoincide) {
    // The camera looks along the world's -z from (0, 0, 3), and the object's frame is the world's.
    Light light = spot_light({1, 2, 4}, {{-1, -2, -3}, degrees(5), degrees(20), 3});
    light.range = 9;
    const Accumulator world = lit<TypeParam>({.lights = {light}});
    EXPECT_FALSE(is_black(world));
    light.space = Space::object;
    EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {light}}), world));
    light.space = Space::view, light.position = {1, 2, 1};
    EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {light}}), world));
}

TYPED_TEST(Lamp, AnObjectsSpotTurnsWithIt) {
    Setting s{.lights = {spot_light({1, 2, 4}, {{-1, -2, -3}, degrees(5), degrees(20), 3})}};
    s.lights[0].space = Space::object, s.material.specular = black;
    const Accumulator before = lit<TypeParam>(s);
    s.pose.rotation = rotate_y(degrees(77)) * rotate_x(degrees(31));
    EXPECT_TRUE(are_equal(lit<TypeParam>(s), before));
    s.lights[0].space = Space::world;
    EXPECT_FALSE(are_equal(lit<TypeParam>(s), before));
}

}  // namespace
}  // namespace shade16
