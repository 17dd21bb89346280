#include "shade16/num/accumulator.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace shade16 {
namespace {

TEST(Accumulator, SaturatesInsteadOfTurningDark) {
    uint32_t sum = UINT32_MAX - 1;
    accumulate(sum, 1);
    EXPECT_EQ(sum, UINT32_MAX);
    accumulate(sum, 1);
    EXPECT_EQ(sum, UINT32_MAX);
    accumulate(sum, UINT32_MAX);
    EXPECT_EQ(sum, UINT32_MAX);
}

TEST(Accumulator, HasRoomForSixtyFourLightsThatAddTwo) {
    uint32_t sum = 0;
    for (int light = 0; light < 64; ++light) accumulate(sum, 2 * Accumulator::one);
    EXPECT_EQ(sum, 64 * 2 * Accumulator::one);
    for (int light = 0; light < 65; ++light) accumulate(sum, 2 * Accumulator::one);
    EXPECT_EQ(sum, UINT32_MAX) << "more of them must not wrap";
}

TEST(Accumulator, TermsAreRoundedDownAndSaturated) {
    for (const uint32_t product : {1u, 2u, 3u, 0x7FFFu, 0x10000u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
        for (int shift = -40; shift <= 40; ++shift) {
            // 64 bits hold product * 2^31; beyond, anything but 0 is saturated.
            uint64_t exact = shift >= 0 ? uint64_t{product} >> shift : uint64_t{product} << std::min(-shift, 32);
            ASSERT_EQ(scaled_term(product, shift), std::min<uint64_t>(exact, UINT32_MAX)) << product << " * 2^-" << shift;
        }
    }
}

TEST(Accumulator, NoLightIsNoTermHoweverStrongTheLamp) {
    for (int shift = -40; shift <= 40; ++shift) ASSERT_EQ(scaled_term(0, shift), 0u) << shift;
}

TEST(Accumulator, ColoursConvertWithinOneUnitAndOneIsOne) {
    static_assert(as_accumulator(Unorm16{65535}) == Accumulator::one && as_accumulator(Unorm16{0}) == 0);
    for (uint32_t raw = 0; raw < 65536; ++raw) {
        const int64_t exact_times_65535 = int64_t{raw} << Accumulator::fraction_bits;
        const int64_t error = int64_t{as_accumulator(Unorm16::from_raw(raw))} * 65535 - exact_times_65535;
        ASSERT_LE(error < 0 ? -error : error, 65535) << raw;
    }
}

}  // namespace
}  // namespace shade16
