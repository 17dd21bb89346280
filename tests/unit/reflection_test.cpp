// Blinn-Phong's and Phong's highlights: their peak, where they are absent, and how wide they are beside each other.
#include <cmath>
#include <numbers>
#include <random>

#include "shade16/target/pixel.hpp"
#include "unit/lit_point.hpp"

namespace shade16 {
namespace {

template <class Tier>
class Highlights : public ::testing::Test {};
using Tiers = ::testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(Highlights, Tiers);

constexpr Reflection models[] = {Reflection::blinn_phong, Reflection::phong};

uint32_t code(uint32_t sum, int bits) { return (min(sum, Accumulator::one) * ((uint32_t{1} << bits) - 1) + (uint32_t{1} << 23)) >> 24; }
uint32_t code(Unorm16 c, int bits) { return static_cast<uint32_t>(std::lround(c.raw / 65535.0 * ((1 << bits) - 1))); }
Unorm16 color_of_code(uint32_t k, uint32_t largest) { return Unorm16::from_raw((k * 65535 + largest / 2) / largest); }

// Whole exponents and fractions between, from 1 to 1000; N = L = V in any direction.
TYPED_TEST(Highlights, PeakAtTheSpecularColour) {
    std::mt19937_64 random{71};
    for (const Reflection model : models)
        for (int i = 0; i <= 600; ++i) {
            const Q16 exponent = Q16::from_raw(static_cast<int32_t>(std::lround(65536 * std::pow(1000.0, i / 600.0))));
            Setting s{.material = {.diffuse = white, .shininess = exponent, .reflection = model}, .component = Component::specular};
            const auto any = [&random] { return Q16::from_raw(static_cast<int32_t>(random()) >> 14); };
            s.camera.eye = i == 0 ? Vec3{0, 0, 3} : Vec3{any(), any(), any()};
            s.lights = {directional_light(s.camera.eye)};
            const Normal30 n = normalize(s.camera.eye);
            const auto narrowed = [](Q30 v) { return Unit14{static_cast<int16_t>(shift_right_round(v.raw, 16))}; };
            const Normal14 normal{narrowed(n.x), narrowed(n.y), narrowed(n.z)};
            for (int k = 0; k < 24; ++k) {
                const uint32_t of_8 = static_cast<uint32_t>(random() % 256), of_5 = static_cast<uint32_t>(random() % 32), of_6 = static_cast<uint32_t>(random() % 64);
                s.material.specular = {color_of_code(of_8, 255), color_of_code(of_6, 63), color_of_code(of_5, 31)};
                const Accumulator sum = lit<TypeParam>(s, normal);
                ASSERT_EQ(code(sum.r, 8), of_8) << "exponent " << exponent.raw / 65536.0;
                ASSERT_EQ(code(sum.g, 6), of_6) << "exponent " << exponent.raw / 65536.0;
                ASSERT_EQ(code(sum.b, 5), of_5) << "exponent " << exponent.raw / 65536.0;
            }
            s.material.specular = white;
            const Accumulator sum = lit<TypeParam>(s, normal);
            ASSERT_TRUE(code(sum.r, 8) == 255 && code(sum.g, 6) == 63 && code(sum.b, 5) == 31);
        }
}

// A white light leaves a colour as it is, as ambient light and as the light of a surface that faces it.
TYPED_TEST(Highlights, WhiteTimesAColourIsThatColour) {
    for (uint32_t raw = 0; raw < 65536; raw += 7) {
        const Rgb c{Unorm16::from_raw(raw), Unorm16::from_raw(65535 - raw), Unorm16::from_raw(raw / 3)};
        const Setting s{.material = {.diffuse = c}, .lights = {ambient_light(white)}};
        // Two units of 2^-24: the product is rounded down twice.
        const Accumulator sum = lit<TypeParam>(s), exact = as_accumulator(c);
        ASSERT_LE(exact.r - sum.r, 2u);
        ASSERT_LE(exact.g - sum.g, 2u);
        ASSERT_LE(exact.b - sum.b, 2u);
    }
    for (uint32_t k = 0; k < 256; ++k) {
        const Rgb c{Unorm16::from_code8(k), Unorm16::from_code8(255 - k), Unorm16::from_code8(k / 2)};
        const Accumulator sum = lit<TypeParam>({.material = {.diffuse = c}, .lights = {directional_light({0, 0, 1})}});
        ASSERT_EQ(code(sum.r, 8), code(c.r, 8));
        ASSERT_EQ(code(sum.g, 8), code(c.g, 8));
        ASSERT_EQ(code(sum.b, 8), code(c.b, 8));
    }
}

TYPED_TEST(Highlights, OfPhongStandWhereTheMirroredLightMeetsTheViewer) {
    Setting s{.material = {.diffuse = black, .specular = white, .shininess = 100, .reflection = Reflection::phong}};
    s.camera = {.eye = {3, 0, 4}, .viewer = Viewer::infinite};
    s.lights = {directional_light({-3, 0, 4})};
    EXPECT_EQ(code(lit<TypeParam>(s).r, 8), 255u) << "the mirror direction";
    s.lights = {directional_light({3, 0, 4})};
    const double mirrored = 16 / 25.0 - 9 / 25.0;  // R.V where light and viewer are on the same side
    EXPECT_NEAR(static_cast<double>(lit<TypeParam>(s).r) / Accumulator::one, std::pow(mirrored, 100), 1e-3);
    s.material.shininess = 1;
    EXPECT_NEAR(static_cast<double>(lit<TypeParam>(s).r) / Accumulator::one, mirrored, 3e-3);
    s.camera.eye = {4, 0, 3}, s.lights = {directional_light({4, 0, 3})};
    EXPECT_TRUE(is_black(lit<TypeParam>(s))) << "R.V below 0";
    s.lights = {directional_light({-4, 0, -3})};
    EXPECT_TRUE(is_black(lit<TypeParam>(s))) << "light from behind";
}

// Blinn-Phong has no highlight at L = -V, where its half vector has no direction. Phong needs no exception: R.V = 1 - 2 (N.L)^2, on
// surfaces that face away from the viewer.
TYPED_TEST(Highlights, OfPhongAreSmoothDownToTheLightOppositeTheViewer) {
    Setting s{.material = {.diffuse = black, .specular = white, .shininess = 8, .reflection = Reflection::phong}};
    s.camera = {.eye = {3, 0, 0}};
    for (int degrees = 1; degrees < 90; ++degrees) {
        const double a = degrees * std::numbers::pi / 180;  // of the surface above the light's path
        const auto unit = [](double v) { return Unit14{static_cast<int16_t>(std::lround(v * 16384))}; };
        s.lights = {directional_light({-1, 0, 0})};
        const Normal14 normal{unit(-std::sin(a)), {}, unit(std::cos(a))};
        const double n_dot_l = std::sin(std::atan2(-normal.x.raw, normal.z.raw));  // as stored
        const double exact = std::pow(std::fmax(1 - 2 * n_dot_l * n_dot_l, 0), 8);
        const double got = static_cast<double>(lit<TypeParam>(s, normal).r) / Accumulator::one;
        EXPECT_NEAR(got, exact, TypeParam::promise.to_exponent_128.micro * 1e-6 / 255) << degrees << " degrees";
    }
    s.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .viewer = Viewer::local};
    s.lights = {directional_light({0, 0, 1})};
    EXPECT_TRUE(is_black(lit<TypeParam>(s))) << "an eye exactly at the point sees none";
}

// Over all angles in one plane: the viewer turns by 2a where the half vector turns by a.
TEST(Reflection, MatchingExponentsMakeHighlightsOfOneWidth) {
    double worst = 0, worst_of_narrow = 0;
    for (int n = 4; n <= 1000; ++n) {
        const Q16 blinn = Q16::from_int(n), phong = phong_shininess_matching(blinn);
        EXPECT_EQ(blinn_phong_shininess_matching(phong), blinn);
        const double m = phong.raw / 65536.0;
        double difference = 0;
        for (int i = 0; i <= 900; ++i) {
            const double a = i * std::numbers::pi / 1800;
            difference = std::fmax(difference, std::fabs(std::pow(std::cos(a), n) - std::pow(std::fmax(std::cos(2 * a), 0), m)));
        }
        worst = std::fmax(worst, difference * n);
        if (n >= 32) worst_of_narrow = std::fmax(worst_of_narrow, difference * n);
    }
    RecordProperty("difference_times_exponent", std::to_string(worst));
    EXPECT_LE(worst, matching_max_error.raw / 65536.0);
    EXPECT_GE(worst, matching_max_error.raw / 65536.0 / 1.5);
    EXPECT_LE(worst_of_narrow, 0.6);
}

TEST(Reflection, MatchingExponentsAreClamped) {
    static_assert(phong_shininess_matching(1) == Q16{1} && phong_shininess_matching(Q16::from_raw(INT32_MIN)) == Q16{1});
    static_assert(phong_shininess_matching(2000) == Q16{250} && phong_shininess_matching(50) == 12.5_q16);
    static_assert(blinn_phong_shininess_matching(600) == Q16{1000} && blinn_phong_shininess_matching(0) == Q16{4});
}

}  // namespace
}  // namespace shade16
