// Light at its ends: lamps at a vertex and at the end of the world, light opposite the viewer, exponents outside their range, sixty-four
// strong lamps at once. Against double precision wherever there is a right answer.
#include <cmath>
#include <initializer_list>
#include <random>

#include "host_sim/report/judge.hpp"
#include "unit/lit_point.hpp"

namespace shade16 {
namespace {

constexpr Q16 one_ulp = Q16::from_raw(1), largest = Q16::from_raw(INT32_MAX), smallest = Q16::from_raw(INT32_MIN);

/// A vertex at the origin of a mesh with a stored normal, judged as the accuracy tests judge one. Positions of the mesh's lattice are
/// those of the world, times the pose's scale.
template <class Tier>
host::Verdict judged(const Setting& s, Normal14 normal = facing, Position16 position = {}) {
    constexpr int bits = ScreenVertex<Tier>::channel_bits;
    ScreenVertex<Tier> vertex;
    vertex.set_color(lit<Tier>(s, normal, position));
    const glm::dvec3 color = glm::dvec3(vertex.r, vertex.g, vertex.b) * std::ldexp(1.0, -bits);
    const glm::dvec3 stored = glm::dvec3(position.x, position.y, position.z) * std::ldexp(1.0, -s.mesh.fraction_bits);
    reference::SurfacePoint point{.position = reference::to_world(s.pose, stored),
                                  .normal = reference::normal_to_world(s.pose, glm::dvec3(normal.x.raw, normal.y.raw, normal.z.raw) / 16384.0)};
    const View<Light> lights{s.lights.data(), static_cast<uint32_t>(s.lights.size())};
    return host::judge(color, reference::light_point(s.camera, lights, s.material, s.pose, point), s.material, host::promised<Tier>(bits));
}

template <class Tier>
class LightAtItsEnds : public ::testing::Test {
protected:
    static void expect_kept(const Setting& s, Normal14 normal = facing, Position16 position = {}) {
        const host::Verdict v = judged<Tier>(s, normal, position);
        EXPECT_LE(v.error_levels, v.bound_levels);
    }
};
using Tiers = ::testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(LightAtItsEnds, Tiers);

Q16 q16(double v) { return Q16::from_raw(static_cast<int32_t>(std::lround(v * 65536))); }
Normal14 unit_normal(double x, double y, double z) {
    const double length = std::sqrt(x * x + y * y + z * z);
    const auto unit = [length](double c) { return Unit14{static_cast<int16_t>(std::lround(c / length * 16384))}; };
    return {unit(x), unit(y), unit(z)};
}

// --- Exponents ---

constexpr Q16 exponents[] = {1, 2, 127, 128, 359.99999_q16, 999.5_q16, 1000};

TYPED_TEST(LightAtItsEnds, HighlightsPeakAtTheSpecularColourForAnyExponent) {
    for (const Q16 exponent : {smallest, Q16{-1}, Q16{0}, one_ulp, Q16{1}, Q16{2}, Q16{127}, Q16{128}, 359.99999_q16, Q16{1000}, Q16{1001}, largest}) {
        const Accumulator sum = lit<TypeParam>({.material = {.diffuse = black, .specular = white, .shininess = exponent}, .lights = {directional_light({0, 0, 1})}});
        EXPECT_LE(sum.r, Accumulator::one) << exponent.raw;
        // The table's share of the promise, and two roundings to 16 bits.
        const auto table = static_cast<uint32_t>(Arithmetic<TypeParam>::shininess_max_error.micro * 1e-6 / 255 * Accumulator::one);
        EXPECT_GE(sum.r, Accumulator::one - table - 2 * 256) << exponent.raw;
    }
}

// Named here: Clang 14 does not evaluate literals while it compiles a template.
constexpr Q16 below_range[] = {smallest, -1, 0, one_ulp, 0.99_q16}, above_range[] = {1000.01_q16, 1001, largest};

TYPED_TEST(LightAtItsEnds, ExponentsOutsideTheirRangeAreTheNearestEnd) {
    for (const Vec3 towards : {Vec3{0, 0, 1}, Vec3{1, 0, 1}, Vec3{1, 0, 8}, Vec3{0, 1, 100}, Vec3{9, 0, 1}}) {
        const auto with = [&](Q16 exponent) {
            return lit<TypeParam>({.material = {.diffuse = black, .specular = white, .shininess = exponent}, .lights = {directional_light(towards)}});
        };
        for (const Q16 low : below_range) EXPECT_TRUE(are_equal(with(low), with(1)));
        for (const Q16 high : above_range) EXPECT_TRUE(are_equal(with(high), with(1000)));
    }
}

TYPED_TEST(LightAtItsEnds, AnyExponentKeepsThePromiseAcrossTheHighlight) {
    for (const Q16 exponent : exponents)
        for (int i = 0; i <= 200; ++i) {
            const double angle = 1.5 * i / 200 * i / 200;  // more of them where the highlight is
            this->expect_kept({.material = {.diffuse = black, .specular = white, .shininess = exponent}, .lights = {directional_light({q16(100 * std::sin(angle)), 0, q16(100 * std::cos(angle))})}});
        }
}

// --- Light opposite the viewer ---

// H = (L + V) / |L + V| has no direction at L = -V. On the way there the promise grows as 0.5 / |L + V|, and no highlight exceeds Ks.
TYPED_TEST(LightAtItsEnds, OppositeTheViewerTheHighlightStaysBetweenNothingAndItsPeak) {
    for (const Q16 exponent : exponents)
        for (int octave = 0; octave <= 31; ++octave)
            for (const double side : {-1.0, 1.0}) {
                Setting s{.material = {.diffuse = black, .specular = white, .shininess = exponent}};
                // Along -z but for 2^-octave; the surface stands across, so that it faces both light and half vector.
                s.lights = {directional_light({Q16::from_raw(static_cast<int32_t>(side * (INT32_MAX >> octave))), 0, smallest})};
                const Normal14 normal = unit_normal(side, 0, -0.01);
                this->expect_kept(s, normal);
                const Accumulator sum = lit<TypeParam>(s, normal);
                EXPECT_LE(sum.r, Accumulator::one) << octave;
            }
}

// --- Where lamps stand ---

TYPED_TEST(LightAtItsEnds, ALampAtAVertexAddsNothing) {
    const Setting s{.lights = {point_light({}), ambient_light(rgb(0x404040))}};
    EXPECT_TRUE(are_equal(lit<TypeParam>(s), lit<TypeParam>({.lights = {ambient_light(rgb(0x404040))}})));
    Setting spot{.lights = {spot_light({}, {}, white, 1000), ambient_light(rgb(0x404040))}};
    EXPECT_TRUE(are_equal(lit<TypeParam>(spot), lit<TypeParam>({.lights = {ambient_light(rgb(0x404040))}})));
}

TYPED_TEST(LightAtItsEnds, ALampBesideAVertexKeepsThePromise) {
    for (const Viewer viewer : {Viewer::infinite, Viewer::local})
        for (const int32_t steps : {1, 2, 3, 4, 5, 100})  // in ulp: a step of the mesh's lattice is four
            for (const Vec3 place : {Vec3{{}, {}, Q16::from_raw(steps)}, Vec3{Q16::from_raw(steps), {}, Q16::from_raw(steps)}, Vec3{Q16::from_raw(-steps), Q16::from_raw(3 * steps), Q16::from_raw(2 * steps)}})
                this->expect_kept({.camera = {.viewer = viewer}, .lights = {point_light(place)}});
}

TYPED_TEST(LightAtItsEnds, AnEyeBesideAVertexKeepsThePromise) {
    for (const int32_t steps : {1, 2, 5, 100})
        this->expect_kept({.camera = {.eye = {{}, Q16::from_raw(steps), Q16::from_raw(2 * steps)}, .viewer = Viewer::local}, .lights = {directional_light({1, 1, 2})}});
}

TYPED_TEST(LightAtItsEnds, LampsAtTheEndsOfTheWorldKeepThePromise) {
    for (const Q16 x : {smallest, Q16{}, largest})
        for (const Q16 y : {smallest, one_ulp, largest})
            for (const Q16 z : {one_ulp, Q16{1}, largest})
                this->expect_kept({.lights = {point_light({x, y, z})}});
}

TYPED_TEST(LightAtItsEnds, DirectionsOfAnyLengthAreTheSame) {
    const Accumulator one = lit<TypeParam>({.lights = {directional_light({1, 2, 3})}});
    for (const int32_t length : {1, 2, 3, 5, 1000, 10'000'000, INT32_MAX / 3}) {
        const auto raw = [length](int32_t c) { return Q16::from_raw(c * length); };
        EXPECT_TRUE(are_equal(lit<TypeParam>({.lights = {directional_light({raw(1), raw(2), raw(3)})}}), one)) << length;
    }
}

TYPED_TEST(LightAtItsEnds, ARangeBelowZeroIsNone) {
    Setting s{.lights = {point_light({1, 0, 2})}};
    const Accumulator endless = lit<TypeParam>(s);
    for (const Q16 range : {smallest, -one_ulp, Q16{}}) {
        s.lights[0].range = range;
        EXPECT_TRUE(are_equal(lit<TypeParam>(s), endless));
    }
    s.lights[0].range = one_ulp;
    EXPECT_TRUE(is_black(lit<TypeParam>(s)));
}

TYPED_TEST(LightAtItsEnds, LightKeepsThePromiseAllTheWayToTheEndOfItsRange) {
    Setting s{.material = {.diffuse = white}, .lights = {point_light({})}};
    s.lights[0].range = 1024;
    for (int32_t distance = 1; distance <= 1040; ++distance) {
        s.lights[0].position.z = Q16::from_int(distance);
        this->expect_kept(s);
        const uint32_t sum = lit<TypeParam>(s).r;
        EXPECT_TRUE(distance < 1024 || sum == 0) << distance;
        EXPECT_TRUE(distance > 1000 || sum > 0) << distance;
    }
}

// --- How strong they are ---

TYPED_TEST(LightAtItsEnds, SixtyFourLightsOfTwoKeepThePromise) {
    // Dark enough to stay below white; from all sides, each with a highlight of its own.
    Setting s{.material = {.diffuse = {{600}, {300}, {0}}, .specular = {{300}, {0}, {300}}, .shininess = 30}};
    for (int i = 0; i < 64; ++i) {
        const double turn = i * 2.4, up = (i + 0.5) / 64;  // a golden spiral over the upper half
        const double out = std::sqrt(1 - up * up);
        s.lights.push_back(i % 2 ? point_light({q16(4 * out * std::cos(turn)), q16(4 * out * std::sin(turn)), q16(4 * up)}, white, 2)
                                 : directional_light({q16(out * std::cos(turn)), q16(out * std::sin(turn)), q16(up)}, white, 2));
    }
    this->expect_kept(s);
    const Accumulator sum = lit<TypeParam>(s);
    EXPECT_GT(sum.r, Accumulator::one / 4) << "they do shine";
    EXPECT_LT(sum.r, Accumulator::one);
}

TYPED_TEST(LightAtItsEnds, LightsAddUpToTheAccumulatorsEndAndStayThere) {
    const Light two = directional_light({0, 0, 1}, white, 2);
    Setting s{.material = {.diffuse = white}};
    uint32_t previous = 0;
    for (int lights = 1; lights <= 300; ++lights) {
        s.lights.push_back(two);
        const uint32_t sum = lit<TypeParam>(s).r;
        ASSERT_GE(sum, previous) << lights;
        const double exact = std::min(2.0 * lights, 256.0), promise = TypeParam::promise.to_exponent_128.micro * 1e-6 / 255;
        ASSERT_NEAR(std::ldexp(sum, -24), exact, exact * promise) << lights;
        previous = sum;
    }
    EXPECT_EQ(previous, UINT32_MAX);
    ScreenVertex<TypeParam> vertex;
    vertex.set_color(lit<TypeParam>(s));
    EXPECT_EQ(vertex.r, 1u << ScreenVertex<TypeParam>::channel_bits) << "white";
}

TYPED_TEST(LightAtItsEnds, TheWeakestLightIsNothingAndTheStrongestIsWhite) {
    for (const int exponent : {-24, -100, -1000, int{INT16_MIN}})
        EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({0, 0, 1}, white, Scaled{0x80000000u, exponent})}}))) << exponent;
    for (const int exponent : {10, 100, 1000, int{INT16_MAX}}) {
        EXPECT_TRUE(are_equal(lit<TypeParam>({.material = {.diffuse = white}, .lights = {directional_light({0, 0, 1}, white, Scaled{UINT32_MAX, exponent})}}),
                              {UINT32_MAX, UINT32_MAX, UINT32_MAX}))
            << exponent;
        EXPECT_TRUE(is_black(lit<TypeParam>({.lights = {directional_light({0, 0, -1}, white, Scaled{UINT32_MAX, exponent})}}))) << exponent;
    }
}

TYPED_TEST(LightAtItsEnds, NegativeAttenuationIsNone) {
    Setting s{.lights = {point_light({1, 0, 2})}};
    s.lights[0].attenuation = {1, 0, 3, 0};
    const Accumulator quadratic_alone = lit<TypeParam>(s);
    s.lights[0].attenuation = {1, smallest, 3, smallest};
    EXPECT_TRUE(are_equal(lit<TypeParam>(s), quadratic_alone));
}

// --- Surfaces ---

// One in a thousand by axis, and a thousand to one: normals go by the inverse transpose, which a square would overflow.
TYPED_TEST(LightAtItsEnds, AScaleOfOneToAThousandKeepsThePromise) {
    std::mt19937_64 random{62};
    const auto uniform = [&random] { return std::uniform_real_distribution<double>(-1, 1)(random); };
    const Vec3 scales[] = {{1, 1000, 1}, {0.001_q16, 1, 1}, {1, 0.03_q16, 30}, {1000, 1000, 1000}, {0.001_q16, 0.001_q16, 0.001_q16}};
    for (const Vec3& scale : scales)
        for (int i = 0; i < 400; ++i) {
            Setting s{.pose = {.scale = scale}};
            s.lights = {directional_light({q16(uniform()), q16(uniform()), q16(uniform())}), point_light({q16(30 * uniform()), q16(30 * uniform()), q16(30 * uniform())})};
            const auto coordinate = [&] { return static_cast<int16_t>(32767 * uniform()); };
            this->expect_kept(s, unit_normal(uniform(), uniform(), uniform()), {coordinate(), coordinate(), coordinate()});
        }
}

// A stored normal is of unit length; of one that is not nothing is promised but that it is no error.
TEST(OddNormals, OfAnyLengthAreDefined) {
    constexpr Normal14 longest{{-32768}, {-32768}, {-32768}}, opposite = normalize14<7>({1, 1, 1}), along = normalize14<7>({-1, -1, -1});
    constexpr int64_t apart = int64_t{opposite.x.raw} + 32768;
    static_assert(detail::chord(longest, opposite) == static_cast<uint32_t>(3 * apart * apart));
    static_assert(detail::chord(Normal14{{-32768}, {}, {}}, Normal14{{16384}, {}, {}}) == 49152u * 49152u && "more than 31 bits");
    static_assert(detail::reflected_chord(longest, along, along) <= 3u * (65535u * 65535u >> 2));
    static_assert(detail::cosine(longest, along) == 65535 && detail::cosine(longest, opposite) == 0 && detail::cosine(Normal14{}, along) == 0);
}

}  // namespace
}  // namespace shade16
