#include "shade16/num/mat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace shade16 {
namespace {

// The farthest entry of m * transpose(m) from the identity.
double orthonormality_error(const Mat3& m) {
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            worst = std::fmax(worst, std::fabs(std::ldexp(static_cast<double>(dot(m.row[i], m.row[j])), -60) - (i == j)));
    return worst;
}

struct RandomAngles {
    std::mt19937 random{8};
    Angle next() { return {static_cast<uint32_t>(random())}; }
    Mat3 rotation() { return rotate_x(next()) * rotate_y(next()) * rotate_z(next()); }
};

TEST(Mat, RotationsAreOrthonormal) {
    RandomAngles angles;
    double worst = 0;
    for (int i = 0; i < 20'000; ++i) worst = std::fmax(worst, orthonormality_error(angles.rotation()));
    RecordProperty("worst", std::to_string(worst * 1e9) + "e-9");
    EXPECT_LE(worst, 1e-8);
}

TEST(Mat, ARotationTimesItsTransposeIsTheIdentity) {
    RandomAngles angles;
    for (int i = 0; i < 20'000; ++i) {
        const Mat3 m = angles.rotation(), product = m * transpose(m);
        for (int r = 0; r < 3; ++r) {
            const IVec3 got = raw(product.row[r]), identity = raw(Mat3{}.row[r]);
            ASSERT_LE(std::abs(got.x - identity.x), 11);  // 1e-8 in ulp of Q30
            ASSERT_LE(std::abs(got.y - identity.y), 11);
            ASSERT_LE(std::abs(got.z - identity.z), 11);
        }
    }
}

TEST(Mat, RotatesCounterClockwiseWhenTheAxisPointsAtTheViewer) {
    static_assert(rotate_z(90_deg) * Vec3{1, 0, 0} == Vec3{0, 1, 0});
    static_assert(rotate_x(90_deg) * Vec3{0, 1, 0} == Vec3{0, 0, 1});
    static_assert(rotate_y(90_deg) * Vec3{0, 0, 1} == Vec3{1, 0, 0});
    static_assert(rotate_z(0_deg) == Mat3{});
}

TEST(Mat, RotateRoundsOnceAndSaturates) {
    __extension__ typedef __int128 Wide;
    RandomAngles angles;
    std::mt19937_64 random{9};
    int64_t worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Mat3 m = angles.rotation();
        const int shift = static_cast<int>(random() & 31), extra = static_cast<int>(random() % 21);
        const auto component = [&] { return i % 100 == 0 ? INT32_MIN : static_cast<int32_t>(random()) >> shift; };
        const IVec3 v{component(), component(), component()}, r = rotate(m, v, extra);
        const int32_t got[3] = {r.x, r.y, r.z};
        for (int k = 0; k < 3; ++k) {
            const IVec3 row = raw(m.row[k]);
            const Wide exact = Wide{row.x} * v.x + Wide{row.y} * v.y + Wide{row.z} * v.z;  // 30 fraction bits more
            const Wide nearest = std::clamp<Wide>((exact + (Wide{1} << (29 - extra))) >> (30 - extra), INT32_MIN, INT32_MAX);
            worst = std::max(worst, static_cast<int64_t>(nearest > got[k] ? nearest - got[k] : got[k] - nearest));
        }
    }
    // 0.5 ulp and the three guard bits that are dropped: never more than the neighbour of the nearest.
    EXPECT_LE(worst, 1);
}

TEST(Mat, RotateByTheIdentityGivesTheExtraBits) {
    static_assert(rotate(Mat3{}, {3, -5, 7}, 8) == IVec3{768, -1280, 1792});
    static_assert(rotate(Mat3{}, {INT32_MIN, INT32_MAX, 0}) == IVec3{INT32_MIN, INT32_MAX, 0});
    static_assert(rotate(Mat3{}, {INT32_MIN, INT32_MAX, 0}, 1) == IVec3{INT32_MIN, INT32_MAX, 0});
}

TEST(Mat, ATransformTimesItsInverseIsTheIdentity) {
    RandomAngles angles;
    std::mt19937_64 random{10};
    for (int i = 0; i < 20'000; ++i) {
        const auto coordinate = [&random] { return Q16::from_raw(static_cast<int32_t>(random()) >> 6); };  // within 512
        const Mat3x4 m{angles.rotation(), {coordinate(), coordinate(), coordinate()}};
        const Mat3x4 identity = m * inverse(m);
        // 512 units of 1e-8 each are 0.34 ulp; three roundings come on top.
        ASSERT_LE(std::abs(identity.translation.x.raw), 2);
        ASSERT_LE(std::abs(identity.translation.y.raw), 2);
        ASSERT_LE(std::abs(identity.translation.z.raw), 2);
        ASSERT_LE(orthonormality_error(identity.rotation), 2e-8);
    }
}

TEST(Mat, RotationOfTheSmallestVectorDoesNotOverflow) {
    static_assert(rotate_y(180_deg) * Vec3{-32768, -32768, -32768} == Vec3{Q16::from_raw(INT32_MAX), -32768, Q16::from_raw(INT32_MAX)});
}

}  // namespace
}  // namespace shade16
