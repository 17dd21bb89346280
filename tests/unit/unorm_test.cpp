#include "shade16/num/unorm.hpp"

#include <gtest/gtest.h>

namespace shade16 {
namespace {

TEST(Unorm, EveryEightBitCodeIsExact) {
    // raw / 65535 == code / 255, without a division.
    for (uint32_t code = 0; code < 256; ++code) EXPECT_EQ(Unorm16::from_code8(code).raw * 255u, code * 65535u);
}

TEST(Unorm, SaturatesAtOne) {
    static_assert(Unorm16::from_code8(256) == Unorm16{65535} && Unorm16::from_code8(UINT32_MAX) == Unorm16{65535});
    static_assert(Unorm16::from_raw(65536).raw == 65535 && Unorm16::from_raw(UINT32_MAX).raw == 65535);
}

TEST(Unorm, WidenedIsTheSameNumber) {
    // raw / 65535 == widened / (2^32 - 1); read over 2^32 it is at most 2^-32 low.
    for (uint32_t raw = 0; raw < 65536; ++raw) {
        const uint64_t widened = Unorm16::from_raw(raw).widened();
        ASSERT_EQ(widened * 65535, uint64_t{raw} * UINT32_MAX);
        ASSERT_LE((uint64_t{raw} << 32) - widened * 65535, 65535u);
    }
    static_assert(Unorm16{65535}.widened() == UINT32_MAX && Unorm16{}.widened() == 0);
}

TEST(Unorm, HexadecimalColoursReadAsWritten) {
    static_assert(rgb(0xFF8000) == Rgb{{65535}, {128 * 257}, {0}});
    static_assert(rgb(0xFFFFFF) == white && rgb(0) == black);
    static_assert(rgb(0xFF123456) == rgb(0x123456), "a fourth byte is no colour");
}

}  // namespace
}  // namespace shade16
