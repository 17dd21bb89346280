#include "shade16/num/block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shade16 {
namespace {

// 64 bits of mantissa where the machine has them; the bounds below leave room for 53.
long double value_of(Block b) { return std::ldexp(static_cast<long double>(b.mantissa), b.exponent); }
long double value_of(Scaled s) { return std::ldexp(static_cast<long double>(s.mantissa), s.exponent - 32); }

struct RandomBlocks {
    std::mt19937_64 random{16};
    Block next() { return {static_cast<int64_t>(random()) >> (1 + (random() % 62)), static_cast<int>(random() % 80) - 40}; }
    Scaled next_scaled() { return {static_cast<uint32_t>(random()) | 0x80000000u, static_cast<int>(random() % 80) - 40}; }
};

TEST(Block, ShortenedKeepsThirtyOneBits) {
    RandomBlocks blocks;
    for (int i = 0; i < 100'000; ++i) {
        const Block b = blocks.next(), s = b.shortened();
        ASSERT_LE(magnitude(s.mantissa), uint64_t{1} << 31);
        ASSERT_LE(std::fabs(value_of(s) - value_of(b)), std::fabs(value_of(b)) * std::ldexp(1.0L, -31));
    }
    static_assert(Block{5, 3}.shortened().mantissa == 5 && Block{0, 9}.shortened().mantissa == 0);
}

TEST(Block, TopBoundsTheNumberTightly) {
    RandomBlocks blocks;
    for (int i = 0; i < 100'000; ++i) {
        const Block b = blocks.next();
        if (b.mantissa == 0) continue;
        ASSERT_LE(std::fabs(value_of(b)), std::ldexp(1.0L, b.top()));
        ASSERT_GE(std::fabs(value_of(b)), std::ldexp(1.0L, b.top() - 1));
    }
    static_assert(Block{}.top() < -500 && Block{-1, 0}.top() == 1);
}

TEST(Block, InUnitsOfRoundsAndSaturates) {
    static_assert(Block{5, 0}.in_units_of(1) == 3 && Block{-5, 0}.in_units_of(1) == -2 && Block{5, 0}.in_units_of(-4) == 80);
    static_assert(Block{1, 0}.in_units_of(-31) == INT32_MAX && Block{-1, 0}.in_units_of(-31) == INT32_MIN);
    static_assert(Block{1, 0}.in_units_of(500) == 0 && Block{1, 0}.in_units_of(-500) == INT32_MAX && Block{}.in_units_of(-500) == 0);
}

TEST(Block, ProductsKeepThirtyBits) {
    RandomBlocks blocks;
    for (int i = 0; i < 100'000; ++i) {
        const Block b = blocks.next();
        const Scaled k = blocks.next_scaled();
        const long double exact = value_of(b) * value_of(k);
        ASSERT_LE(std::fabs(value_of(b * k) - exact), std::fabs(exact) * std::ldexp(1.0L, -30));
    }
    static_assert((Block{} * Scaled(3)).mantissa == 0 && (Block{7, 2} * Scaled{}).mantissa == 0);
}

TEST(Block, SumsLoseOnlyBitsFarBelowTheLarger) {
    RandomBlocks blocks;
    for (int i = 0; i < 100'000; ++i) {
        const Block a = blocks.next(), b = blocks.next();
        const long double largest = std::fmax(std::fabs(value_of(a)), std::fabs(value_of(b)));
        ASSERT_LE(std::fabs(value_of(a + b) - (value_of(a) + value_of(b))), largest * std::ldexp(1.0L, -50));
        ASSERT_LE(std::fabs(value_of(a - b) - (value_of(a) - value_of(b))), largest * std::ldexp(1.0L, -50));
    }
}

TEST(Block, SumsOfVeryDifferentNumbersKeepTheLarger) {
    constexpr Block large{1, 900}, small{1, -900};
    static_assert(large.top() == 901);
    EXPECT_EQ(value_of(large + small), value_of(large));
    EXPECT_EQ(value_of(small + large), value_of(large));
    EXPECT_EQ(value_of(Block{} + small), value_of(small));
    EXPECT_EQ(value_of(small - Block{}), value_of(small));
}

TEST(Block, SumsRoundWhatIsSixtyThreeBitsBelow) {
    constexpr Block large{INT64_C(1) << 62, 0}, nearly_four{INT64_MAX, -61}, nearly_two{INT64_MAX, -62};
    static_assert((large + nearly_four).mantissa == (INT64_C(1) << 60) + 1 && (large + nearly_four).exponent == 2);
    static_assert((large - nearly_four).mantissa == (INT64_C(1) << 60) - 1);
    static_assert((large + nearly_two).mantissa == INT64_C(1) << 60);
}

TEST(BlockVector, ComponentProductIsExact) {
    constexpr Vec3 a{1.5_q16, -2, Q16::from_raw(INT32_MIN)}, b{-3, 0.25_q16, Q16::from_raw(INT32_MIN)};
    constexpr BlockVector product = component_product(a, b);
    EXPECT_EQ(value_of(product.x), -4.5L);
    EXPECT_EQ(value_of(product.y), -0.5L);
    EXPECT_EQ(value_of(product.z), 1073741824.0L);
    EXPECT_EQ(value_of(as_block(b).y), 0.25L);
}

TEST(BlockVector, MatrixProductsKeepTwentyNineBits) {
    RandomBlocks blocks;
    for (int i = 0; i < 50'000; ++i) {
        const auto angle = [&blocks] { return Angle{static_cast<uint32_t>(blocks.random())}; };
        const Mat3 m = rotate_x(angle()) * rotate_y(angle());
        const BlockVector v{blocks.next(), blocks.next(), blocks.next()}, r = m * v;
        const long double largest = std::fmax(std::fmax(std::fabs(value_of(v.x)), std::fabs(value_of(v.y))), std::fabs(value_of(v.z)));
        const Block got[3] = {r.x, r.y, r.z};
        for (int k = 0; k < 3; ++k) {
            const IVec3 row = raw(m.row[k]);
            const long double exact = std::ldexp(row.x * value_of(v.x) + row.y * value_of(v.y) + row.z * value_of(v.z), -30);
            ASSERT_LE(std::fabs(value_of(got[k]) - exact), largest * std::ldexp(1.0L, -29));
        }
    }
}

TEST(BlockVector, OfZeroStaysZero) {
    constexpr BlockVector zero = rotate_x(45_deg) * BlockVector{};
    static_assert(zero.x.mantissa == 0 && zero.y.mantissa == 0 && zero.z.mantissa == 0);
    static_assert(BlockVector{}.in_units_of(-20) == IVec3{});
}

}  // namespace
}  // namespace shade16
