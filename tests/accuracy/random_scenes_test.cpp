// Two hundred scenes of everything that there is, drawn in every tier, each pixel inside its promise.
#include <cstdio>

#include <gtest/gtest.h>

#include "accuracy/random_scene.hpp"
#include "host_sim/report/compare.hpp"

namespace shade16::host {
namespace {

constexpr int scene_count = 200;
constexpr Viewport frame_size{48, 36};

template <class Tier>
class RandomScenes : public testing::Test {};
using Tiers = testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(RandomScenes, Tiers);

TYPED_TEST(RandomScenes, KeepThePromise) {
    Comparison sum;
    Needs seen;
    double worst_vertex = 0, worst_pixel = 0, worst_table = 0;
    for (int i = 0; i < scene_count; ++i) {
        Random random(1000 + static_cast<uint64_t>(i));
        const RandomScene random_scene(random, all_needs);
        const Scene& scene = random_scene.scene();
        seen = seen | needs_of(scene);
        const reference::Scene exact = reference::value(scene);
        Comparison one;
        compare_frame<TypeParam>(one, exact, exact, {}, frame_size);
        EXPECT_TRUE(one.vertices.holds()) << "scene " << i << ": a vertex takes " << one.vertices.largest_of_bound << " of its bound";
        EXPECT_TRUE(one.pixels.holds()) << "scene " << i << ": a pixel takes " << one.pixels.largest_of_bound << " of its bound";
        EXPECT_TRUE(one.tables.holds()) << "scene " << i << ": a light table takes " << one.tables.largest_of_bound << " of its bound";
        worst_vertex = std::max(worst_vertex, one.vertices.largest_of_bound), worst_pixel = std::max(worst_pixel, one.pixels.largest_of_bound);
        worst_table = std::max(worst_table, one.tables.largest_of_bound);
        sum.vertices.count += one.vertices.count, sum.pixels.count += one.pixels.count, sum.tables.count += one.tables.count;
        sum.textured_pixels += one.textured_pixels;
    }
    EXPECT_EQ(seen, all_needs) << "some term was in none of the scenes";
    EXPECT_GT(sum.pixels.count, 50'000u);
    EXPECT_GT(sum.textured_pixels, 5'000u);
    EXPECT_GT(sum.tables.count, 100u);
    std::printf("[ %-7s  ] %d random scenes: vertices take %.3f of their bound, pixels %.3f, light tables %.3f; %zu vertices, %zu channels of pixels\n",
                TypeParam::name, scene_count, worst_vertex, worst_pixel, worst_table, sum.vertices.count, sum.pixels.count);
}

}  // namespace
}  // namespace shade16::host
