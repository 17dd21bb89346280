// One picture, however it is drawn: from a scene in flash or at run time, in bands of any height, with every vertex kept
// or replayed, by the smallest pipeline or by that of all terms. Its scenes are in three files, to compile at the same time.
#pragma once

#include <gtest/gtest.h>

#include "tests/renderer/frames.hpp"

namespace shade16::host {

template <const Scene& s>
struct Named {
    static constexpr const Scene& scene = s;
};

template <class S>
class OnePicture : public testing::Test {};
TYPED_TEST_SUITE_P(OnePicture);

TYPED_TEST_P(OnePicture, ShowsSomething) {
    const auto pixels = compiled<TypeParam::scene, mediump>();
    const auto background = nearest_pixel<Rgb565>(TypeParam::scene.background);
    EXPECT_GT(std::count_if(pixels.begin(), pixels.end(), [&](auto p) { return p != background; }), 300);
}
TYPED_TEST_P(OnePicture, CompiledInEqualsRunTime) {
    EXPECT_EQ((compiled<TypeParam::scene, lowp>()), at_run_time<lowp>(TypeParam::scene));
    EXPECT_EQ((compiled<TypeParam::scene, mediump>()), at_run_time<mediump>(TypeParam::scene));
    EXPECT_EQ((compiled<TypeParam::scene, highp>()), at_run_time<highp>(TypeParam::scene));
}
TYPED_TEST_P(OnePicture, BandsOfAnyHeightEqualTheFullFrame) {
    const auto whole = compiled<TypeParam::scene, mediump>();
    for (const int32_t rows : {1, 2, 7, 8, 31, 71}) EXPECT_EQ((compiled<TypeParam::scene, mediump>(rows)), whole) << rows << " rows";
    EXPECT_EQ((compiled<TypeParam::scene, highp>(7)), (compiled<TypeParam::scene, highp>()));
}
TYPED_TEST_P(OnePicture, ReplayedVerticesEqualKeptOnes) {
    const auto whole = compiled<TypeParam::scene, mediump>();
    EXPECT_EQ((compiled<TypeParam::scene, mediump, VertexStore::replay>()), whole);
    EXPECT_EQ((compiled<TypeParam::scene, mediump, VertexStore::replay>(8)), whole);
    EXPECT_EQ((compiled<TypeParam::scene, mediump, VertexStore::replay, needs_of(TypeParam::scene), 1>(8)), whole) << "one slot";
}
TYPED_TEST_P(OnePicture, MoreNeedsDrawTheSameBits) {
    EXPECT_EQ((compiled<TypeParam::scene, mediump, VertexStore::keep, all_needs>()), (compiled<TypeParam::scene, mediump>()));
    constexpr Needs half = needs_of(TypeParam::scene) | needs_of(torus_scene);
    EXPECT_EQ((compiled<TypeParam::scene, mediump, VertexStore::keep, half>()), (compiled<TypeParam::scene, mediump>()));
}
REGISTER_TYPED_TEST_SUITE_P(OnePicture, ShowsSomething, CompiledInEqualsRunTime, BandsOfAnyHeightEqualTheFullFrame, ReplayedVerticesEqualKeptOnes, MoreNeedsDrawTheSameBits);

}  // namespace shade16::host
