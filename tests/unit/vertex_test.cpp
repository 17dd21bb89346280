#include "shade16/pipeline/vertex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shade16 {
namespace {

TEST(Vertex, IsFourteenBytesInTheSixteenBitTiers) {
    static_assert(sizeof(ScreenVertex<lowp>) == 14 && sizeof(ScreenVertex<mediump>) == 14);
    static_assert(ScreenVertex<mediump>::channel_bits == 15 && ScreenVertex<highp>::channel_bits == 24);
}

TEST(Vertex, ColoursSaturateOnceAndAreRoundedOnce) {
    for (const uint32_t sum : {0u, 1u, 255u, 256u, 257u, Accumulator::one / 2, Accumulator::one - 257, Accumulator::one - 256, Accumulator::one,
                               Accumulator::one + 1, UINT32_MAX}) {
        const uint32_t saturated = std::min(sum, Accumulator::one);
        ScreenVertex<mediump> narrow;
        narrow.set_color({sum, 0, sum});
        EXPECT_EQ(narrow.r, std::floor(saturated / 512.0 + 0.5));
        EXPECT_EQ(narrow.g, 0);
        EXPECT_EQ(narrow.b, narrow.r);
        ScreenVertex<highp> wide;
        wide.set_color({0, sum, 0});
        EXPECT_EQ(wide.g, saturated);
    }
}

TEST(Vertex, ALitVertexKeepsItsOtherFlags) {
    ScreenVertex<mediump> v;
    v.flags = outside_left | is_transformed;
    v.set_color({});
    EXPECT_EQ(v.flags, outside_left | is_transformed | is_lit);
    static_assert((outside_any & (is_lit | is_transformed)) == 0);
}

}  // namespace
}  // namespace shade16
