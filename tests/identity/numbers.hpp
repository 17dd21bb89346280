// Arguments for kernels: the same on every machine, of every magnitude, with the edges among them.
#pragma once

#include "shade16/num/angle.hpp"
#include "shade16/num/normalize.hpp"

namespace shade16::identity {

/// Draws that stand in one expression must stand in braces, which fix their order; arguments of a call have none.
class Numbers {
public:
    /// 32 bits, each as likely 0 as 1. Source: Marsaglia, "Xorshift RNGs", 2003.
    constexpr uint32_t bits() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        return state_ ^= state_ << 5;
    }
    /// 0 to count - 1. Range: count up to 2^16.
    constexpr uint32_t below(uint32_t count) { return (bits() >> 16) * count >> 16; }

    /// As many of each length, and half of them powers of two and their neighbours: 0, the largest and INT32_MIN too.
    constexpr uint32_t any() {
        const uint32_t power = uint32_t{1} << below(32);
        switch (below(8)) {
            case 0: return power;
            case 1: return power - 1;
            case 2: return power + 1;
            case 3: return 0u - power;
            default: return bits() >> below(32);
        }
    }
    constexpr int32_t any_signed() {
        const uint32_t x = any();
        return static_cast<int32_t>(below(2) == 0 ? x : 0u - x);
    }
    constexpr uint64_t any64() {
        const uint64_t high = any();
        const uint64_t all = high << 32 | any();
        return all >> below(64);
    }
    constexpr int64_t any_signed64() {
        const uint64_t x = any64();
        return static_cast<int64_t>(below(2) == 0 ? x : 0u - x);
    }

    /// With the top bit set.
    constexpr uint32_t mantissa() {
        const uint32_t x = any();
        return below(2) == 0 || x == 0 ? bits() | uint32_t{1} << 31 : x << leading_zeros(x);
    }
    /// Mostly of exponents that occur, and some at the ends of what an exponent holds.
    constexpr Scaled scaled() {
        const int32_t near = static_cast<int32_t>(below(129)) - 64, far = static_cast<int32_t>(below(65536)) - 32768;
        if (below(32) == 0) return {};
        const int16_t exponent = static_cast<int16_t>(below(8) == 0 ? far : near);
        return {mantissa(), exponent};
    }
    constexpr Q16 q16() { return Q16::from_raw(any_signed()); }
    /// From 0 to 1 less 2^-16.
    constexpr Q16 share() {
        const uint32_t below_end = below(65535);
        return Q16::from_raw(static_cast<int32_t>(below_end + below(2)));
    }
    constexpr Angle angle() { return {below(4) == 0 ? any() : bits()}; }
    constexpr IVec3 ivec3() { return {any_signed(), any_signed(), any_signed()}; }
    constexpr Vec3 vec3() { return {q16(), q16(), q16()}; }
    constexpr Normal30 unit30() { return normalize_finely(ivec3()); }
    constexpr Normal14 unit14() { return normalize14<7>(ivec3()); }

private:
    uint32_t state_ = 0x9E3779B9;
};

}  // namespace shade16::identity
