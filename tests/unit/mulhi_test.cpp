#include "shade16/num/mulhi.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace shade16 {
namespace {

__extension__ typedef unsigned __int128 Wide;

const std::vector<uint32_t>& edge_words() {
    static const std::vector<uint32_t> edges = [] {
        std::vector<uint32_t> words;
        for (int bit = 0; bit < 32; ++bit)
            for (const uint32_t near : {0xFFFFFFFFu, 0u, 1u}) words.push_back((uint32_t{1} << bit) + near);
        words.insert(words.end(), {0, UINT32_MAX, UINT32_MAX - 1, 0xFFFF0000u, 0x0000FFFFu, 0x00010001u, 0xAAAAAAAAu, 0x55555555u});
        return words;
    }();
    return edges;
}

// Calls check(a, b) for every pair of edge words and for a million random pairs.
template <class Check>
void for_pairs(Check check) {
    for (const uint32_t a : edge_words())
        for (const uint32_t b : edge_words()) check(a, b);
    std::mt19937_64 random{2};
    for (int i = 0; i < 1'000'000; ++i) {
        const uint64_t pair = random();
        check(static_cast<uint32_t>(pair), static_cast<uint32_t>(pair >> 32));
    }
}

TEST(Mulhi, NarrowBodiesGiveTheBitsOfTheWideOnes) {
    for_pairs([](uint32_t a, uint32_t b) {
        const int32_t sa = static_cast<int32_t>(a), sb = static_cast<int32_t>(b);
        ASSERT_EQ(narrow::multiply(a, b), wide::multiply(a, b)) << a << " * " << b;
        ASSERT_EQ(narrow::multiply(sa, b), wide::multiply(sa, b)) << sa << " * " << b;
        ASSERT_EQ(narrow::multiply(sa, sb), wide::multiply(sa, sb)) << sa << " * " << sb;
        ASSERT_EQ(narrow::mulhi(a, b), wide::mulhi(a, b)) << a << " * " << b;
        ASSERT_EQ(narrow::mulhi(sa, b), wide::mulhi(sa, b)) << sa << " * " << b;
        ASSERT_EQ(narrow::mulhi(sa, sb), wide::mulhi(sa, sb)) << sa << " * " << sb;
    });
}

TEST(Mulhi, WideBodiesAreTheProduct) {
    static_assert(wide::multiply(UINT32_MAX, UINT32_MAX) == 0xFFFFFFFE00000001u);
    static_assert(wide::multiply(INT32_MIN, INT32_MIN) == int64_t{1} << 62);
    static_assert(wide::multiply(INT32_MIN, UINT32_MAX) == INT64_MIN + (int64_t{1} << 31));
    static_assert(narrow::multiply(INT32_MIN, UINT32_MAX) == INT64_MIN + (int64_t{1} << 31));
    static_assert(narrow::multiply(-1, -1) == 1);
}

TEST(Mulhi, TheHighWordIsFloored) {
    for_pairs([](uint32_t a, uint32_t b) {
        const int32_t sa = static_cast<int32_t>(a), sb = static_cast<int32_t>(b);
        ASSERT_EQ(mulhi(a, b), static_cast<uint32_t>(uint64_t{a} * b >> 32));
        ASSERT_EQ(mulhi(sa, sb), static_cast<int32_t>((int64_t{sa} * sb) >> 32));
        ASSERT_EQ(mulhi(sa, b), static_cast<int32_t>((int64_t{sa} * int64_t{b}) >> 32));
    });
    static_assert(mulhi(int32_t{-1}, int32_t{1}) == -1);
}

TEST(Mulhi, SixtyFourBitWordsMultiplyLikeInt128) {
    const auto check = [](uint64_t a, uint64_t b) {
        ASSERT_EQ(mulhi(a, b), static_cast<uint64_t>(Wide{a} * b >> 64)) << a << " * " << b;
    };
    for (const uint32_t high : edge_words())
        for (const uint32_t low : edge_words()) {
            const uint64_t a = uint64_t{high} << 32 | low;
            for (const uint64_t b : {uint64_t{0}, uint64_t{1}, UINT64_MAX, uint64_t{1} << 32, uint64_t{UINT32_MAX}, a, ~a}) check(a, b);
        }
    std::mt19937_64 random{3};
    for (int i = 0; i < 1'000'000; ++i) check(random() >> (random() & 63), random());
    static_assert(mulhi(UINT64_MAX, UINT64_MAX) == UINT64_MAX - 1);
}

}  // namespace
}  // namespace shade16
