#include "shade16/num/rounded.hpp"

#include <gtest/gtest.h>

#include <random>

namespace shade16 {
namespace {

__extension__ typedef unsigned __int128 Wide;

void check_root(uint64_t n) {
    const uint64_t root = rounded_root(n);  // (root - 1/2)^2 <= n <= (root + 1/2)^2, times four
    ASSERT_LE(Wide{4} * n, Wide{2 * root + 1} * (2 * root + 1)) << n;
    ASSERT_GE(Wide{4} * n, root == 0 ? Wide{0} : Wide{2 * root - 1} * (2 * root - 1)) << n;
}

TEST(Rounded, RootIsTheNearest) {
    for (uint64_t n = 0; n < 100'000; ++n) check_root(n);
    std::mt19937_64 random{41};
    for (int i = 0; i < 1'000'000; ++i) {
        check_root(random() >> (1 + random() % 63));
        const uint64_t root = (random() >> 33) + 1;
        for (const uint64_t near : {root * root - 1, root * root, root * root + 1, root * root + root, root * root + root + 1}) check_root(near);
    }
    static_assert(rounded_root(uint64_t{1} << 63) == 3037000500u && rounded_root(uint64_t{1} << 62) == uint32_t{1} << 31 && rounded_root(0) == 0);
}

void check_quotient(uint64_t n, uint32_t d) {
    const uint64_t q = rounded_quotient(n, d);
    if ((n >> 32) >= d) {
        ASSERT_EQ(q, UINT32_MAX);
        return;
    }
    const Wide twice = Wide{2} * n;
    ASSERT_GE(twice, (Wide{2 * q} - (q != 0)) * d) << n << " / " << d;
    ASSERT_TRUE(q == UINT32_MAX || twice < Wide{2 * q + 1} * d) << n << " / " << d;
}

TEST(Rounded, QuotientIsTheNearest) {
    std::mt19937_64 random{42};
    for (int i = 0; i < 2'000'000; ++i) {
        const auto d = static_cast<uint32_t>(random() >> (32 + random() % 32));
        check_quotient(random() >> (random() & 63), d);
        const uint64_t whole = (random() >> 32) * d;
        for (const uint64_t near : {whole - 1, whole, whole + 1, whole + d / 2, whole + d / 2 + 1}) check_quotient(near, d);
    }
    for (const uint32_t d : {1u, 2u, 3u, 0x7FFFFFFFu, 0x80000000u, 0x80000001u, 0xFFFFFFFFu})
        for (uint64_t near = 0; near < 1000; ++near) {
            check_quotient((uint64_t{d} << 32) - near, d);
            check_quotient(near, d);
        }
    static_assert(rounded_quotient(7, 2) == 4 && rounded_quotient(0, 5) == 0 && rounded_quotient(1, 0) == UINT32_MAX);
}

}  // namespace
}  // namespace shade16
