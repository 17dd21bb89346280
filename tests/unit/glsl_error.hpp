// How far GLSL functions are from double precision, in units of Q16, over numbers that find out.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

#include "shade16/num/q16.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16::glsl {

inline double value(Q16 x) { return x.raw / 65536.0; }

// The largest error seen, against a bound that is neither broken nor padded.
class Worst {
public:
    explicit Worst(const char* name) : name_(name) {}

    // The exact value is first brought into the range of Q16.
    void add(Q16 got, double exact) {
        const double nearest = in_range(exact), error = std::fabs(got.raw - nearest);
        if (error > worst_) worst_ = error, at_ = nearest;
    }
    // Beyond half a unit, in shares of `size`.
    void add_relative(Q16 got, double exact, double size) {
        const double error = std::fabs(got.raw - in_range(exact)) - 0.501;
        worst_relative_ = std::fmax(worst_relative_, error / std::fabs(size * 65536));
    }
    void expect(Ulps bound) const {
        std::printf("[ measured ] %-12s %.4f ulp of %.3f, at %.6g\n", name_, worst_, bound.milli / 1000.0, at_ / 65536);
        EXPECT_LE(worst_, bound.milli / 1000.0) << name_;
        EXPECT_GE(worst_ * 1.5, bound.milli / 1000.0) << name_ << " promises less than it holds";
    }
    void expect_relative(int bound_log2) const {
        std::printf("[ measured ] %-12s 2^%.2f of 2^%d\n", name_, std::log2(worst_relative_), bound_log2);
        EXPECT_LE(worst_relative_, std::ldexp(1.0, bound_log2)) << name_;
        EXPECT_GE(worst_relative_ * 1.5, std::ldexp(1.0, bound_log2)) << name_ << " promises less than it holds";
    }

private:
    static double in_range(double exact) { return std::fmin(std::fmax(exact * 65536, INT32_MIN), INT32_MAX); }

    const char* name_;
    double worst_ = 0, at_ = 0, worst_relative_ = 0;
};

// Calls f for numbers all over the range, for every one near 0 and 1 and near each power of two, and for both ends.
template <class F>
void over_the_range(F f, int64_t stride = 4'001) {
    for (int64_t raw = INT32_MIN; raw <= INT32_MAX; raw += stride) f(Q16::from_raw(static_cast<int32_t>(raw)));
    for (int32_t raw = -140'000; raw <= 140'000; ++raw) f(Q16::from_raw(raw));
    for (int bit = 1; bit < 31; ++bit)
        for (int32_t near = -40; near <= 40; ++near)
            for (const int32_t sign : {-1, 1}) f(Q16::from_raw(sign * ((int32_t{1} << bit) + near)));
    for (int32_t near = 0; near < 100; ++near) f(Q16::from_raw(INT32_MAX - near)), f(Q16::from_raw(INT32_MIN + near));
}

// Random numbers of all magnitudes.
class AnyNumber {
public:
    explicit AnyNumber(uint64_t seed) : random_(seed) {}
    Q16 operator()() { return of_bits(1 + static_cast<int>(random_() % 32)); }
    Q16 of_bits(int bits) {
        const auto raw = static_cast<int64_t>(random_() >> (64 - bits)) - (random_() & 1 ? int64_t{1} << (bits - 1) : 0);
        return Q16::from_raw(saturate(raw));
    }
    uint64_t bits() { return random_(); }

private:
    std::mt19937_64 random_;
};

}  // namespace shade16::glsl
