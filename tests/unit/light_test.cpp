// Light sources (scene/light.hpp) and what they do to a point (pipeline/light.hpp). The promises on its error are the
// accuracy tests'; here is what must hold exactly.
#include "shade16/pipeline/light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shade16/pipeline/vertex.hpp"
#include "unit/lit_point.hpp"

namespace shade16 {
namespace {

template <class Tier>
class Lit : public ::testing::Test {};
using Tiers = ::testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(Lit, Tiers);

constexpr Vec3 uneven{1, 0.3_q16, 2}, close{0, 0, 0.5_q16};
constexpr Attenuation linear{1, 1, 0}, quadratic{1, 0, 1}, all_three{0.5_q16, 0.25_q16, 2}, only_quadratic{0, 0, 1}, negative{1, -3, -5}, nothing{0, 0, 0};

TYPED_TEST(Lit, NoLightIsBlack) {
    EXPECT_TRUE(is_black(lit<TypeParam>({})));
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({0, 0, 1}, black)}})));
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({0, 0, 1}, white, Scaled{})}})));
    const Accumulator glows = lit<TypeParam>({.material = {.emissive = white}});
    EXPECT_TRUE(are_equal(glows, {Accumulator::one, Accumulator::one, Accumulator::one})) << "what is emitted, alone";
}

TYPED_TEST(Lit, LightFromBehindIsZeroAndNotNegative) {
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({0, 0, -1})}})));
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({1, 0, 0})}}))) << "light along the surface";
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {point_light({0, 0, -5})}})));
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({0, 0, 1})}}, averted)));
    // It takes nothing from another light either.
    const Accumulator alone = lit<TypeParam>({.lights = {directional_light({0, 0, 1})}});
    EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {directional_light({0, 0, 1}), directional_light({0, 0, -1})}}), alone));
}

TYPED_TEST(Lit, AZeroNormalOrDirectionGivesNoDiffuseAndNoSpecular) {
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({0, 0, 1}), point_light({0, 0, 5})}}, Normal14{})));
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({0, 0, 0})}})));
    EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {point_light({0, 0, 0})}}))) << "a lamp exactly at the point";
}

TYPED_TEST(Lit, LightFacingTheSurfaceGivesItsFullColour) {
    const Material matt{.diffuse = white};
    const Accumulator sum = lit<TypeParam>({.material = matt, .lights = {directional_light({0, 0, 1})}});
    // One 16-bit product and one 16-bit cosine, both rounded down at most by their last bit.
    EXPECT_GE(sum.r, Accumulator::one - 3 * 256u);
    EXPECT_LE(sum.r, Accumulator::one);
    EXPECT_EQ(sum.r, sum.g);
    EXPECT_EQ(sum.r, sum.b);
}

TYPED_TEST(Lit, LightOppositeTheViewerGivesNoSpecular) {
    // L = -V: the half vector has no direction. The surface faces the light, away from the viewer.
    const Setting with{.lights = {directional_light({0, 0, -1})}};
    Setting without = with;
    without.material.specular = black;
    EXPECT_TRUE(are_equal(lit<TypeParam>(with, averted), lit<TypeParam>(without, averted)));
    Setting local = with;
    local.camera.viewer = Viewer::local;
    local.lights = {point_light({0, 0, -3})};
    without = local;
    without.material.specular = black;
    EXPECT_TRUE(are_equal(lit<TypeParam>(local, averted), lit<TypeParam>(without, averted)));
    EXPECT_FALSE(is_black(lit<TypeParam>(local, averted))) << "diffuse light is there";
}

TYPED_TEST(Lit, AnEyeExactlyAtThePointSeesNoSpecular) {
    Setting with{.lights = {directional_light({0, 0, 1})}};
    with.camera.viewer = Viewer::local;
    with.camera.eye = {}, with.camera.target = {0, 0, -1};
    Setting without = with;
    without.material.specular = black;
    EXPECT_TRUE(are_equal(lit<TypeParam>(with), lit<TypeParam>(without)));
}

TYPED_TEST(Lit, LightsAdd) {
    const Light a = directional_light({1, 2, 3}, rgb(0x604020)), b = point_light({-1, 1, 4}, rgb(0x102030));
    const Accumulator first = lit<TypeParam>({.lights = {a}}), second = lit<TypeParam>({.lights = {b}});
    EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {a, b}}), {first.r + second.r, first.g + second.g, first.b + second.b}));
    EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {a, b}}), lit<TypeParam>({.lights = {b, a}}))) << "in any order";
}

TYPED_TEST(Lit, AmbientAndEmissiveLightAdd) {
    Material glowing{.ambient = rgb(0x808080), .diffuse = black, .emissive = rgb(0x202020)};
    const Accumulator sum = lit<TypeParam>({.material = glowing, .lights = {ambient_light(white), ambient_light(rgb(0x808080))}});
    // 128/255 + (128/255)^2 + 32/255, each product within a unit.
    const double exact = 128.0 / 255 + 128.0 * 128 / 65025 + 32.0 / 255;
    EXPECT_NEAR(sum.r, exact * Accumulator::one, 4);
    EXPECT_EQ(sum.r, sum.g);
}

TYPED_TEST(Lit, SaturationComesOnceAtTheEnd) {
    const Material matt{.diffuse = white};
    const Light strong = directional_light({0, 0, 1}, rgb(0xC0C0C0));
    const Accumulator one = lit<TypeParam>({.material = matt, .lights = {strong}}), two = lit<TypeParam>({.material = matt, .lights = {strong, strong}});
    EXPECT_EQ(two.r, 2 * one.r) << "the sum passes 1.0 unclamped";
    EXPECT_GT(two.r, Accumulator::one);
    ScreenVertex<TypeParam> v;
    v.set_color(two);
    EXPECT_EQ(v.r, 1u << ScreenVertex<TypeParam>::channel_bits);
}

TYPED_TEST(Lit, VertexColoursAreAFactorOnAllButTheHighlight) {
    const Rgb half{{32768}, {0}, {65535}};
    Setting s{.lights = {directional_light({0, 0, 1}, rgb(0x404040))}};
    const Accumulator plain = lit<TypeParam>(s);
    s.color = &half;
    const Accumulator colored = lit<TypeParam>(s);
    EXPECT_LT(colored.r, plain.r);
    EXPECT_EQ(colored.b, plain.b - 1) << "white is a factor of 1 - 2^-32, rounded down";
    s.material.diffuse = black;
    EXPECT_TRUE(are_equal(lit<TypeParam>(s), [&s] { s.color = nullptr; return lit<TypeParam>(s); }()));
}

TYPED_TEST(Lit, AFarPointLightIsADirectionalOne) {
    const Accumulator far = lit<TypeParam>({.lights = {point_light({0, 0, 32767})}}), directional = lit<TypeParam>({.lights = {directional_light({0, 0, 1})}});
    EXPECT_TRUE(are_equal(far, directional));
}

// 1 / (constant + linear d + quadratic d^2) at d = 2 and at d = 0.5, on a lattice of 2^-14.
TYPED_TEST(Lit, AttenuationFadesWithDistance) {
    const Material matt{.diffuse = white};
    const auto at = [&](Vec3 place, Attenuation attenuation) {
        Light light = point_light(place);
        light.attenuation = attenuation;
        return static_cast<double>(lit<TypeParam>({.material = matt, .lights = {light}}).r) / Accumulator::one;
    };
    // Of 16-bit products, cosines and factors, and of the length of the light's direction.
    using A = Arithmetic<TypeParam>;
    const double rounding = 4.0 / 65536 + (A::wide ? 0 : std::ldexp(A::rsqrt_bits == 6 ? rsqrt_49_max_error : rsqrt_97_max_error, -32));
    EXPECT_NEAR(at({0, 0, 2}, {}), 1, rounding);
    EXPECT_NEAR(at({0, 0, 2}, linear), 1.0 / 3, rounding);
    EXPECT_NEAR(at({0, 0, 2}, quadratic), 1.0 / 5, rounding);
    EXPECT_NEAR(at({0, 0, 2}, all_three), 1 / (0.5 + 2 * 0.25 + 4 * 2.0), rounding);
    EXPECT_NEAR(at(close, quadratic), 1 / 1.25, rounding);
    EXPECT_NEAR(at(close, only_quadratic), 4, 4 * rounding) << "a factor above 1";
    EXPECT_NEAR(at({0, 0, 2}, negative), 1, rounding) << "negative factors count as 0";
}

TYPED_TEST(Lit, AnInfinitelyStrongNearLampSaturates) {
    Light light = point_light({0, 0, 2});
    light.attenuation = nothing;
    const Accumulator sum = lit<TypeParam>({.lights = {light}});
    EXPECT_EQ(sum.r, UINT32_MAX) << "1 / 0 is the largest factor";
}

TYPED_TEST(Lit, SpacesAgreeWhereTheyCoincide) {
    // The camera looks along the world's -z from (0, 0, 3), and the object's frame is the world's.
    Light light = point_light({1, 2, 4});
    const Accumulator world = lit<TypeParam>({.lights = {light}});
    light.space = Space::object;
    EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {light}}), world));
    light.space = Space::view, light.position = {1, 2, 1};
    EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {light}}), world));
    Light sun = directional_light({1, 2, 4});
    const Accumulator day = lit<TypeParam>({.lights = {sun}});
    sun.space = Space::view;
    EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {sun}}), day));
}

// Random scenes: every further light, ambient or not, adds or leaves it as it is.
TYPED_TEST(Lit, MoreLightIsNeverDarker) {
    std::mt19937_64 random{31};
    const auto any = [&random] { return Q16::from_raw(static_cast<int32_t>(random()) >> (random() % 20)); };
    const auto color = [&random] { return rgb(static_cast<uint32_t>(random()) & 0xFFFFFF); };
    for (int i = 0; i < 12'000; ++i) {
        Setting s;
        s.camera.viewer = i & 1 ? Viewer::local : Viewer::infinite;
        s.material = {.diffuse = color(), .specular = color(), .shininess = Q16::from_raw(static_cast<int32_t>(random() % 65'536'000))};
        if (i % 3 == 0) s.pose.scale = uneven;
        const Normal14 normal = normalize14<7>({any().raw, any().raw, any().raw});
        const Position16 position{static_cast<int16_t>(random()), static_cast<int16_t>(random()), static_cast<int16_t>(random())};
        Accumulator previous{};
        for (int n = 0; n < 4; ++n) {
            const Scaled intensity = Scaled::normalized(random() >> 32, static_cast<int>(random() % 12) - 36);
            Light light = random() % 2 ? point_light({any(), any(), any()}, color(), intensity) : directional_light({any(), any(), any()}, color(), intensity);
            light.space = static_cast<Space>(random() % 3);
            if (random() % 8 == 0) light.kind = LightKind::ambient;
            if (random() % 2 == 0) light.attenuation = {any(), any(), any(), any()};
            if (random() % 3 == 0) light.range = any();
            if (random() % 3 == 0 && light.kind == LightKind::point) {
                light.kind = LightKind::spot;
                light.spot = {{any(), any(), any()}, {static_cast<uint32_t>(random())}, {static_cast<uint32_t>(random())}, any()};
            }
            s.material.reflection = static_cast<Reflection>(i / 2 % 2);
            s.lights.push_back(light);
            const Accumulator sum = lit<TypeParam>(s, normal, position);
            ASSERT_GE(sum.r, previous.r);
            ASSERT_GE(sum.g, previous.g);
            ASSERT_GE(sum.b, previous.b);
            previous = sum;
        }
    }
}

TYPED_TEST(Lit, AStrongerLampIsNeverDarker) {
    std::mt19937_64 random{32};
    for (int i = 0; i < 20'000; ++i) {
        const Rgb color = rgb(static_cast<uint32_t>(random()) & 0xFFFFFF);
        const uint64_t mantissa = random() >> 32;
        const int exponent = static_cast<int>(random() % 40) - 40;
        const auto sum_of = [&](uint64_t m) {
            Setting s{.lights = {directional_light({1, 2, 3}, color, Scaled::normalized(m, exponent))}};
            return lit<TypeParam>(s);
        };
        const Accumulator weak = sum_of(mantissa), strong = sum_of(mantissa + mantissa / 100 + 1);
        // A product has as many digits as its brightest channel leaves: a dim one may lose half a unit of 2^-16 of it.
        const uint64_t unit = max(weak.r, max(weak.g, weak.b)) >> (Arithmetic<TypeParam>::wide ? 24 : 15);
        ASSERT_GE(strong.r + unit + 2, weak.r);
        ASSERT_GE(strong.g + unit + 2, weak.g);
        ASSERT_GE(strong.b + unit + 2, weak.b);
    }
}

TYPED_TEST(Lit, AVeryStrongLampSaturates) {
    const Accumulator sum = lit<TypeParam>({.lights = {directional_light({0, 0, 1}, white, 4'000'000'000_scaled)}});
    EXPECT_EQ(sum.r, UINT32_MAX);
    EXPECT_EQ(sum.g, UINT32_MAX);
    EXPECT_EQ(sum.b, UINT32_MAX);
}

TYPED_TEST(Lit, TotalForAnyInput) {
    std::mt19937_64 random{33};
    for (int i = 0; i < 20'000; ++i) {
        const auto any = [&random, i] { return Q16::from_raw(static_cast<int32_t>(random()) >> (i % 32)); };
        const auto any_vector = [&any] { return Vec3{any(), any(), any()}; };
        Setting s{.camera = {.eye = any_vector(), .target = any_vector(), .up = any_vector(), .viewer = i & 1 ? Viewer::local : Viewer::infinite}};
        s.material.shininess = any();
        s.pose = {.scale = any_vector(), .translation = any_vector()};
        s.mesh.centre = any_vector();
        s.mesh.fraction_bits = static_cast<int8_t>(random() % 31);
        s.lights = {point_light(any_vector()), directional_light(any_vector())};
        s.lights[0].attenuation = {any(), any(), any(), any()};
        s.lights[0].range = any();
        if (i % 3 == 0) s.lights[0].kind = LightKind::spot;
        s.lights[0].spot = {any_vector(), {static_cast<uint32_t>(random())}, {static_cast<uint32_t>(random())}, any()};
        s.material.reflection = static_cast<Reflection>(i / 4 % 2);
        s.lights[static_cast<size_t>(i & 1)].space = static_cast<Space>(random() % 3);
        lit<TypeParam>(s, normalize14<7>({any().raw, any().raw, any().raw}), {-32768, 32767, -32768});
    }
}

TEST(Light, ConstructorsSetWhatTheirNamesSay) {
    static_assert(ambient_light(rgb(0x102030)).kind == LightKind::ambient && ambient_light(white).specular == black);
    static_assert(directional_light({0, 1, 0}).intensity == Scaled(1) && directional_light({0, 1, 0}).kind == LightKind::directional);
    static_assert(point_light({0, 1, 0}, rgb(0x102030)).diffuse == rgb(0x102030) && point_light({0, 1, 0}, rgb(0x102030)).specular == rgb(0x102030));
    static_assert(Light{}.intensity == Scaled(1) && Light{}.space == Space::world);
}

}  // namespace
}  // namespace shade16
