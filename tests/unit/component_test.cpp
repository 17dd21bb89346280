// The light's components (scene/scene.hpp): alone, and added up.
#include <random>

#include "unit/lit_point.hpp"

namespace shade16 {
namespace {

template <class Tier>
class Components : public ::testing::Test {};
using Tiers = ::testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(Components, Tiers);

struct Parts {
    Accumulator all, ambient, diffuse, specular;
};
template <class Tier>
Parts parts_of(Setting s, Normal14 normal, Position16 position) {
    const auto part = [&](Component c) {
        s.component = c;
        return lit<Tier>(s, normal, position);
    };
    return {part(Component::all), part(Component::ambient), part(Component::diffuse), part(Component::specular)};
}

// Scenes with every kind of light, below saturation of the accumulator.
class RandomSetting {
public:
    Setting next() {
        Setting s;
        s.camera.viewer = coin() ? Viewer::local : Viewer::infinite;
        s.material = {.ambient = color(), .diffuse = color(), .specular = color(), .emissive = color()};
        s.material.shininess = Q16::from_raw(static_cast<int32_t>(random_() % 65'536'000));
        s.material.reflection = static_cast<Reflection>(random_() % 2);
        for (int i = 0; i < 4; ++i) {
            Light light{.kind = static_cast<LightKind>(random_() % 4), .position = {any(), any(), any()}, .diffuse = color(), .specular = color()};
            light.space = static_cast<Space>(random_() % 3);
            light.intensity = Scaled::normalized(random_() >> 32, static_cast<int>(random_() % 4) - 32);
            light.range = any();
            light.spot = {{any(), any(), any()}, {}, 85_deg, 1};
            s.lights.push_back(light);
        }
        return s;
    }
    Normal14 normal() { return normalize14<7>({any().raw, any().raw, any().raw}); }
    Position16 position() { return {coordinate(), coordinate(), coordinate()}; }
    Rgb color() { return {{static_cast<uint16_t>(random_())}, {static_cast<uint16_t>(random_())}, {static_cast<uint16_t>(random_())}}; }

private:
    bool coin() { return random_() & 1; }
    Q16 any() { return Q16::from_raw(static_cast<int32_t>(random_()) >> (8 + random_() % 6)); }
    int16_t coordinate() { return static_cast<int16_t>(random_()); }
    std::mt19937_64 random_{61};
};

TYPED_TEST(Components, AddUpToAllBitForBit) {
    RandomSetting random;
    int with_all_three = 0;
    for (int i = 0; i < 8'000; ++i) {
        const Setting s = random.next();
        const Parts p = parts_of<TypeParam>(s, random.normal(), random.position());
        ASSERT_EQ(p.all.r, p.ambient.r + p.diffuse.r + p.specular.r);
        ASSERT_EQ(p.all.g, p.ambient.g + p.diffuse.g + p.specular.g);
        ASSERT_EQ(p.all.b, p.ambient.b + p.diffuse.b + p.specular.b);
        with_all_three += p.ambient.r != 0 && p.diffuse.r != 0 && p.specular.r != 0;
    }
    EXPECT_GT(with_all_three, 150);
}

TYPED_TEST(Components, WithVertexColoursTheyAddUpWithinOneUnit) {
    RandomSetting random;
    for (int i = 0; i < 2'000; ++i) {
        Setting s = random.next();
        const Rgb color = random.color();
        s.color = &color;
        const Parts p = parts_of<TypeParam>(s, random.normal(), random.position());
        const uint32_t sum = p.ambient.g + p.diffuse.g + p.specular.g;  // each product is rounded down by itself
        ASSERT_TRUE(p.all.g == sum || p.all.g == sum + 1) << p.all.g << ' ' << sum;
    }
}

TYPED_TEST(Components, EmissiveLightIsAmbientAndAnUnlitObjectIsAllOfIt) {
    const Parts glowing = parts_of<TypeParam>({.material = {.diffuse = black, .emissive = rgb(0x102030)}, .lights = {directional_light({0, 0, 1})}}, facing, {});
    EXPECT_FALSE(is_black(glowing.ambient));
    EXPECT_TRUE(is_black(glowing.diffuse) && is_black(glowing.specular) && are_equal(glowing.ambient, glowing.all));
    const Parts sign = parts_of<TypeParam>({.material = {.diffuse = rgb(0x405060), .unlit = true}}, facing, {});
    EXPECT_FALSE(is_black(sign.ambient));
    EXPECT_TRUE(is_black(sign.diffuse) && is_black(sign.specular) && are_equal(sign.ambient, sign.all));
}

}  // namespace
}  // namespace shade16
