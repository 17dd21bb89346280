#include "shade16/target/band.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace shade16 {
namespace {

// 65535 is odd, so no colour lies exactly between two codes.
uint32_t rounded_code(uint32_t raw, int bits) {
    return static_cast<uint32_t>(std::lround(raw * static_cast<double>((1 << bits) - 1) / 65535));
}

TEST(NearestPixel, RoundsEveryValueOfEveryChannel) {
    for (uint32_t raw = 0; raw < 65536; ++raw) {
        const Unorm16 c = Unorm16::from_raw(raw);
        ASSERT_EQ(nearest_pixel<Rgb565>({c, {}, {}}), rounded_code(raw, 5) << 11);
        ASSERT_EQ(nearest_pixel<Rgb565>({{}, c, {}}), rounded_code(raw, 6) << 5);
        ASSERT_EQ(nearest_pixel<Rgb565>({{}, {}, c}), rounded_code(raw, 5));
        ASSERT_EQ(nearest_pixel<Rgb565Swapped>({c, c, c}), Rgb565Swapped::swapped(nearest_pixel<Rgb565>({c, c, c})));
        const uint8_t code = static_cast<uint8_t>(rounded_code(raw, 8));
        ASSERT_EQ(nearest_pixel<Rgb888>({c, c, c}), (Rgb888::Pixel{code, code, code}));
    }
}

TEST(NearestPixel, KeepsEightBitColours) {
    static_assert(nearest_pixel<Rgb888>(rgb(0x123456)) == Rgb888::Pixel{0x12, 0x34, 0x56});
    static_assert(nearest_pixel<Rgb565>(white) == 0xFFFF && nearest_pixel<Rgb565>(black) == 0);
}

TEST(Clear, FillsPixelsAndDepthAndNothingElse) {
    // Every size up to two rounds of an unrolled loop and a rest, at every alignment that halfwords may have.
    constexpr int size = 160;
    alignas(8) uint16_t pixels[size], depth[size];
    for (int32_t width = 1; width <= 49; ++width)
        for (int32_t rows = 1; rows <= 3; ++rows)
            for (int start = 0; start < 4; ++start) {
                for (int i = 0; i < size; ++i) pixels[i] = depth[i] = 0xABCD;
                clear(Band<Rgb565>{pixels + start, depth + start, width, 7, rows}, 0x1234);
                for (int i = 0; i < size; ++i) {
                    const bool is_inside = i >= start && i < start + width * rows;
                    ASSERT_EQ(pixels[i], is_inside ? 0x1234 : 0xABCD);
                    ASSERT_EQ(depth[i], is_inside ? far_depth : 0xABCD);
                }
            }
}

TEST(Clear, FillsPixelsOfThreeBytes) {
    Rgb888::Pixel pixels[12]{};
    clear(Band<Rgb888>{pixels, nullptr, 5, 0, 2}, {1, 2, 3});
    for (int i = 0; i < 12; ++i) ASSERT_EQ(pixels[i], i < 10 ? (Rgb888::Pixel{1, 2, 3}) : Rgb888::Pixel{});
}

// Rows of packed greys begin on a byte: five pixels of 4 bits take three.
constexpr bool clears_packed_rows_alone() {
    uint8_t bytes[10]{};
    bytes[9] = 0xAB;
    clear(Band<Gray4>{bytes, nullptr, 5, 0, 3}, 0x77);  // a byte is two pixels
    for (int i = 0; i < 9; ++i)
        if (bytes[i] != 0x77) return false;
    return bytes[9] == 0xAB;
}
TEST(Clear, FillsPackedRowsToTheirOwnLength) { static_assert(clears_packed_rows_alone()); }

TEST(Clear, DoesWithoutDepth) {
    uint16_t pixels[6] = {1, 1, 1, 1, 1, 1};
    clear(Band<Rgb565>{pixels, nullptr, 3, 0, 2}, 9);
    for (const uint16_t pixel : pixels) EXPECT_EQ(pixel, 9);
}

TEST(Band, RowsAreCountedFromTheFramesTop) {
    BandBuffer<Rgb565, 10, 4> buffer;
    const Band<Rgb565> band = buffer.band(20);
    EXPECT_EQ(band.row(20), buffer.pixels);
    EXPECT_EQ(band.row(23), buffer.pixels + 30);
    EXPECT_EQ(band.depth_row(21), buffer.depth + 10);
    EXPECT_EQ(band.rows, 4);
    EXPECT_EQ(buffer.band(20, 2).rows, 2);
}

TEST(Band, ABufferWithoutDepthHasNone) {
    BandBuffer<Rgb565, 100, 4, false> buffer;
    EXPECT_EQ(buffer.band().depth, nullptr);
    static_assert(sizeof(buffer) < sizeof(BandBuffer<Rgb565, 100, 4>) * 6 / 10);
}

}  // namespace
}  // namespace shade16
