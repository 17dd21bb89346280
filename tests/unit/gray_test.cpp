#include "shade16/target/band.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace shade16 {
namespace {

static_assert(PixelFormat<Gray8> && PixelFormat<Gray4> && PixelFormat<Mono1> && !PackedFormat<Gray8>);
static_assert(PixelFormat<Dithered<Gray4, bayer4>> && PixelFormat<Dithered<Rgb565, bayer8>> && !PackedFormat<Dithered<Rgb565, bayer8>>);
static_assert(!is_placed<Rgb565> && !is_placed<Rgb888> && !is_placed<Gray8> && is_placed<Gray4> && is_placed<Dithered<Gray8, bayer4>>);
static_assert(channels_of_format<Rgb565> == Channels::rgb && channels_of_format<Dithered<Mono1, bayer8>> == Channels::luma);

constexpr uint32_t code24(uint32_t code) { return code << 24; }

TEST(Luma, TheWeightsSumToOneSoThatGreysKeepTheirValue) {
    static_assert(LumaWeights::red + LumaWeights::green + LumaWeights::blue == 65536);
    static_assert(luma_of(white).luma == UINT32_MAX && luma_of(black).luma == 0);
    EXPECT_NEAR(LumaWeights::red / 65536.0, 0.299, 0.5 / 65536);
    EXPECT_NEAR(LumaWeights::green / 65536.0, 0.587, 0.5 / 65536);
    EXPECT_NEAR(LumaWeights::blue / 65536.0, 0.114, 0.5 / 65536);
    for (uint32_t raw = 0; raw < 65536; ++raw) {
        const Unorm16 c = Unorm16::from_raw(raw);
        ASSERT_EQ(luma_of({c, c, c}).luma, c.widened());
        ASSERT_EQ(as_accumulator<Channels::luma>({c, c, c}).luma, as_accumulator(c));
    }
}

TEST(Gray4, TheLeftPixelIsInTheHighNibble) {
    uint8_t row[3] = {0xFF, 0xFF, 0xFF};
    Place<Gray4> place(row, 0, 0);
    for (const uint32_t code : {1u, 2u, 3u, 4u}) place.put(code24(code)), ++place;
    EXPECT_EQ(row[0], 0x12);
    EXPECT_EQ(row[1], 0x34);
    EXPECT_EQ(row[2], 0xFF);
    for (int32_t x = 0; x < 4; ++x) EXPECT_EQ(luma_code<Gray4>(row, x), static_cast<uint32_t>(x + 1));
}

TEST(Mono1, TheLeftmostPixelIsTheHighestBit) {
    for (int32_t x = 0; x < 16; ++x) {
        uint8_t lit[2] = {0, 0}, dark[2] = {255, 255};
        Place<Mono1>(lit, x, 0).put(code24(1));
        Place<Mono1>(dark, x, 0).put(code24(0));
        const int expected = 0x8000 >> x;
        EXPECT_EQ(lit[0] << 8 | lit[1], expected);
        EXPECT_EQ(dark[0] << 8 | dark[1], 0xFFFF ^ expected);
        EXPECT_EQ(luma_code<Mono1>(lit, x), 1u);
        EXPECT_EQ(luma_code<Mono1>(dark, x), 0u);
    }
}

TEST(Band, RowsOfPixelsThatShareBytesBeginOnAByte) {
    const std::vector<int32_t> widths{1, 2, 3, 7, 8, 9, 13}, gray4{1, 1, 2, 4, 4, 5, 7}, mono1{1, 1, 1, 1, 1, 2, 2};
    for (std::size_t i = 0; i < widths.size(); ++i) {
        EXPECT_EQ(pixels_a_row<Gray8>(widths[i]), widths[i]);
        EXPECT_EQ(pixels_a_row<Gray4>(widths[i]), gray4[i]);
        EXPECT_EQ(pixels_a_row<Mono1>(widths[i]), mono1[i]);
    }
    BandBuffer<Mono1, 13, 4> buffer;
    static_assert(sizeof(buffer.pixels) == 8 && buffer.count == 52);
    EXPECT_EQ(buffer.band(20).row(22), buffer.pixels + 4);
    EXPECT_EQ(buffer.band(20).depth_row(22), buffer.depth + 26);
    EXPECT_EQ(buffer.band(20, 3).pixel_bytes(), 6u);
    EXPECT_EQ((BandBuffer<Rgb888, 5, 2>().band().pixel_bytes()), 30u);
}

TEST(Bayer, TheMatricesAreBayers) {
    constexpr uint8_t four[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    for (unsigned y = 0; y < 8; ++y)
        for (unsigned x = 0; x < 8; ++x) {
            EXPECT_EQ(bayer4.thresholds[y][x], four[y % 4][x % 4]);
            EXPECT_EQ(bayer8.thresholds[y][x] / 4, four[y % 4][x % 4]) << "the finer one refines the coarser";
        }
    std::set<int> all;
    for (const auto& row : bayer8.thresholds) all.insert(row, row + 8);
    EXPECT_EQ(all.size(), 64u);
}

template <class Format>
std::vector<uint32_t> cleared(int32_t width, int32_t height, Rgb color) {
    std::vector<typename Format::Pixel> memory(static_cast<std::size_t>(pixels_a_row<Format>(width) * height));
    clear_to(Band<Format>{memory.data(), nullptr, width, 0, height}, color);
    std::vector<uint32_t> codes;
    for (int32_t y = 0; y < height; ++y)
        for (int32_t x = 0; x < width; ++x) {
            const auto* const row = memory.data() + y * pixels_a_row<Format>(width);
            if constexpr (GrayFormat<Format>) codes.push_back(luma_code<Format>(row, x));
            else codes.push_back(row[x] & 31u);  // blue of Rgb565
        }
    return codes;
}

/// The colour as an area of 16 x 16 pixels: no code is a whole one away, and the mean is the colour's to half a threshold's step.
template <class Format>
void expect_mean(Unorm16 c, int bits, int thresholds) {
    const double exact = c.raw / 65535.0 * ((1 << bits) - 1);
    double sum = 0;
    for (const uint32_t code : cleared<Format>(16, 16, {c, c, c})) {
        ASSERT_LT(std::abs(code - exact), 1);
        sum += code;
    }
    ASSERT_LE(std::abs(sum / 256 - exact), 0.5 / thresholds + 1e-4) << c.raw;
}

TEST(Dithered, TheMeanOfAFlatAreaIsItsColour) {
    for (uint32_t raw = 0; raw < 65536; raw += 37) {
        const Unorm16 c = Unorm16::from_raw(raw);
        expect_mean<Dithered<Mono1, bayer4>>(c, 1, 16);
        expect_mean<Dithered<Mono1, bayer8>>(c, 1, 64);
        expect_mean<Dithered<Gray4, bayer4>>(c, 4, 16);
        expect_mean<Dithered<Gray8, bayer8>>(c, 8, 64);
        expect_mean<Dithered<Rgb565, bayer8>>(c, 5, 64);
    }
}

TEST(Dithered, AFlatColourThatIsACodeHasNoNoise) {
    for (uint32_t code = 0; code < 16; ++code) {
        const Unorm16 c = Unorm16::from_raw(code * 65535 / 15);
        for (const uint32_t shown : cleared<Dithered<Gray4, bayer8>>(16, 8, {c, c, c})) ASSERT_EQ(shown, code);
    }
    for (const uint32_t shown : cleared<Dithered<Rgb565, bayer8>>(16, 8, white)) ASSERT_EQ(shown, 31u);
    for (const uint32_t shown : cleared<Dithered<Mono1, bayer4>>(16, 8, white)) ASSERT_EQ(shown, 1u);
    for (const uint32_t shown : cleared<Dithered<Mono1, bayer4>>(16, 8, black)) ASSERT_EQ(shown, 0u);
}

TEST(Dithered, WithoutDitheringTheNearestCodeIsShown) {
    for (uint32_t raw = 0; raw < 65536; raw += 11) {
        const Unorm16 c = Unorm16::from_raw(raw);
        ASSERT_EQ((cleared<Gray4>(1, 1, {c, c, c})[0]), static_cast<uint32_t>(std::lround(raw * 15 / 65535.0)));
        ASSERT_EQ((cleared<Mono1>(1, 1, {c, c, c})[0]), raw < 32768 ? 0u : 1u);
    }
}

TEST(Clear, FillsPixelsThatShareBytesAndNothingElse) {
    for (int32_t width = 1; width <= 40; ++width)
        for (int32_t rows = 1; rows <= 3; ++rows)
            for (int start = 0; start < 3; ++start) {
                std::vector<uint8_t> memory(200, 0xA5);
                std::vector<uint16_t> depth(200, 7);
                const Band<Dithered<Mono1, bayer4>> band{memory.data() + start, depth.data(), width, 5, rows};
                clear_to(band, white);
                for (int i = 0; i < 200; ++i) {
                    const bool inside = i >= start && i < start + pixels_a_row<Mono1>(width) * rows;
                    ASSERT_EQ(memory[static_cast<std::size_t>(i)], inside ? 0xFF : 0xA5);
                    ASSERT_EQ(depth[static_cast<std::size_t>(i)], i < width * rows ? far_depth : 7);
                }
                clear_to(Band<Gray4>{memory.data() + start, nullptr, width, 5, rows}, rgb(0x888888));
                for (int i = 0; i < pixels_a_row<Gray4>(width) * rows; ++i) ASSERT_EQ(memory[static_cast<std::size_t>(start + i)], 0x88);
            }
}

}  // namespace
}  // namespace shade16
