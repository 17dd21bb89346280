#include "shade16/num/vec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace shade16 {
namespace {

__extension__ typedef __int128 Wide;

Vec3 from_raw(int32_t x, int32_t y, int32_t z) { return {Q16::from_raw(x), Q16::from_raw(y), Q16::from_raw(z)}; }

// Distance in ulp between a Q16 and a number of 32 fraction bits, after saturation.
int64_t error_ulp(Q16 got, Wide exact) {
    const Wide nearest = std::clamp<Wide>((exact + 32768) >> 16, INT32_MIN, INT32_MAX);
    const Wide error = nearest - got.raw;
    return static_cast<int64_t>(error < 0 ? -error : error);
}

void check_products(Vec3 a, Vec3 b) {
    const auto product = [](Q16 p, Q16 q) { return Wide{p.raw} * q.raw; };
    ASSERT_LE(error_ulp(dot(a, b), product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z)), 1);
    const Vec3 c = cross(a, b);
    ASSERT_LE(error_ulp(c.x, product(a.y, b.z) - product(a.z, b.y)), 1);
    ASSERT_LE(error_ulp(c.y, product(a.z, b.x) - product(a.x, b.z)), 1);
    ASSERT_LE(error_ulp(c.z, product(a.x, b.y) - product(a.y, b.x)), 1);
}

TEST(Vec, DotAndCrossAreWithinOneUlpAtTheExtremes) {
    const int32_t edges[] = {INT32_MIN, INT32_MIN + 1, -65536, -1, 0, 1, 65536, INT32_MAX - 1, INT32_MAX};
    for (const int32_t ax : edges)
        for (const int32_t ay : edges)
            for (const int32_t az : edges)
                for (const int32_t bx : edges)
                    for (const int32_t by : edges)
                        for (const int32_t bz : {INT32_MIN, -1, 1, INT32_MAX}) check_products(from_raw(ax, ay, az), from_raw(bx, by, bz));
}

TEST(Vec, DotAndCrossAreWithinOneUlpAtRandom) {
    std::mt19937_64 random{7};
    for (int i = 0; i < 200'000; ++i) {
        const int a = static_cast<int>(random() & 31), b = static_cast<int>(random() & 31);
        const auto component = [&random](int shift) { return static_cast<int32_t>(random()) >> shift; };
        check_products(from_raw(component(a), component(a), component(a)), from_raw(component(b), component(b), component(b)));
    }
}

TEST(Vec, FullRangeProductsSaturate) {
    static_assert(dot(Vec3{-32768, -32768, -32768}, Vec3{-32768, -32768, -32768}) == Q16::from_raw(INT32_MAX));
    static_assert(dot(Vec3{-32768, -32768, -32768}, Vec3{32767, 32767, 32767}) == Q16::from_raw(INT32_MIN));
    static_assert(dot(Vec3{32767, -32767, 1}, Vec3{32767, 32767, 1}) == Q16{1});
}

TEST(Vec, CrossFollowsTheRightHand) {
    static_assert(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}) == Vec3{0, 0, 1});
    static_assert(cross(Vec3{0, 1, 0}, Vec3{1, 0, 0}) == Vec3{0, 0, -1});
    static_assert(cross(Vec3{3, 3, 3}, Vec3{3, 3, 3}) == Vec3{});
}

TEST(Vec, DotOfUnitVectorsIsExact) {
    constexpr Normal14 x{{16384}, {}, {}}, y{{}, {16384}, {}}, down{{}, {-16384}, {}};
    static_assert(dot(x, x) == int32_t{1} << 28 && dot(x, y) == 0 && dot(y, down) == -(int32_t{1} << 28));
    constexpr Normal30 wide{{Q30::one}, {}, {}};
    static_assert(dot(wide, wide) == int64_t{1} << 60);
}

TEST(Vec, ArithmeticSaturatesByComponent) {
    constexpr Vec3 big{32767, -32768, 1};
    static_assert(big + big == Vec3{Q16::from_raw(INT32_MAX), -32768, 2});
    static_assert(big - big == Vec3{} && -big == Vec3{-32767, Q16::from_raw(INT32_MAX), -1});
    static_assert(Vec3{1, 2, -3} * 1.5_q16 == Vec3{1.5_q16, 3, -4.5_q16});
}

}  // namespace
}  // namespace shade16
