#include "shade16/target/pixel.hpp"

#include <gtest/gtest.h>

namespace shade16 {
namespace {

TEST(Pixel, Rgb565HasRedOnTop) {
    static_assert(Rgb565::pack(31, 0, 0) == 0xF800 && Rgb565::pack(0, 63, 0) == 0x07E0 && Rgb565::pack(0, 0, 31) == 0x001F);
    static_assert(Rgb565::pack(31, 63, 31) == 0xFFFF && Rgb565::pack(1, 2, 3) == 0x0843);
}

TEST(Pixel, TheSwappedFormatIsTheSameWithItsBytesExchanged) {
    static_assert(Rgb565Swapped::swapped(0x1234) == 0x3412);
    for (uint32_t r = 0; r < 32; ++r)
        for (uint32_t g = 0; g < 64; ++g)
            for (uint32_t b = 0; b < 32; ++b) {
                const uint16_t pixel = Rgb565::pack(r, g, b);
                ASSERT_EQ(Rgb565Swapped::pack(r, g, b), static_cast<uint16_t>(pixel << 8 | pixel >> 8));
            }
}

// [green 6.5 | red 5.6 | blue 5.5]: the fractions are dropped, whatever they are.
TEST(Pixel, AWordGivesItsCodes) {
    for (uint32_t r = 0; r < 32; ++r)
        for (uint32_t g = 0; g < 64; ++g)
            for (uint32_t b = 0; b < 32; ++b)
                for (const uint32_t fractions : {0u, 0x03E0FC1Fu & 0x001F0000u, 0x001F07FFu & ~0x03E0u}) {
                    const uint32_t word = g << 26 | r << 16 | b << 5 | (fractions & 0x03E0FC1Fu & ~(31u << 5)) | (fractions & 0x1F);
                    ASSERT_EQ(Rgb565::from_word(word), Rgb565::pack(r, g, b));
                    ASSERT_EQ(Rgb565Swapped::from_word(word), Rgb565Swapped::pack(r, g, b));
                }
}

TEST(Pixel, Rgb888HasRedFirst) {
    static_assert(sizeof(Rgb888::Pixel) == 3);
    static_assert(Rgb888::pack(1, 2, 3) == Rgb888::Pixel{1, 2, 3});
}

static_assert(PixelFormat<Rgb565> && PixelFormat<Rgb565Swapped> && PixelFormat<Rgb888> && !PixelFormat<int>);
static_assert(PackedFormat<Rgb565> && PackedFormat<Rgb565Swapped> && !PackedFormat<Rgb888>);

}  // namespace
}  // namespace shade16
