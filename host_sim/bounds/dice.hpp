// The numbers of one random case: the same on every machine for the same case.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "shade16/num/mat.hpp"

namespace shade16::bounds {

class Dice {
public:
    explicit Dice(uint64_t number) : state_(number * 0xD1342543DE82EF95) {}

    /// Source: SplitMix64 (Steele, Lea, Flood, 2014).
    uint64_t bits() {
        state_ += 0x9E3779B97F4A7C15;
        uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }
    uint32_t below(uint32_t end) { return static_cast<uint32_t>((bits() >> 32) * end >> 32); }
    int integer(int low, int high) { return low + static_cast<int>(below(static_cast<uint32_t>(high - low) + 1)); }
    double uniform(double low, double high) {
        return low + (high - low) * std::ldexp(static_cast<double>(bits() >> 11), -53);
    }

    /// A word of any magnitude; every fourth is within three of a power of two, 0 or the largest.
    uint32_t word() {
        const uint32_t shift = below(33);
        if (below(4) == 0) return static_cast<uint32_t>(uint64_t{1} << shift) + below(7) - 3;
        return shift == 32 ? 0 : static_cast<uint32_t>(bits()) >> shift;
    }
    uint64_t long_word() {
        const uint32_t shift = below(64);
        if (below(4) == 0) return (uint64_t{1} << shift) + below(7) - 3;
        return bits() >> shift;
    }
    int32_t number() {
        const uint32_t w = word();
        return static_cast<int32_t>(below(2) != 0 ? w : 0u - w);
    }
    int64_t long_number() { return static_cast<int64_t>(long_word()); }
    uint32_t mantissa() { return word() | uint32_t{1} << 31; }
    Q16 q16() { return Q16::from_raw(number()); }

    /// Components of one magnitude, or each of its own.
    IVec3 vector() {
        const uint32_t shift = below(32);
        const auto component = [&] {
            return below(4) == 0 ? number()
                                 : static_cast<int32_t>(bits()) >> std::min(31u, shift + below(4) * below(3));
        };
        return {component(), component(), component()};
    }
    Vec3 vec3() {
        const IVec3 v = vector();
        return {Q16::from_raw(v.x), Q16::from_raw(v.y), Q16::from_raw(v.z)};
    }
    Mat3 rotation() {
        const Angle x{word()}, y{word()}, z{word()};
        return rotate_x(x) * rotate_y(y) * rotate_z(z);
    }
    /// Rounded to Q30.
    Normal30 direction() {
        const double z = uniform(-1, 1), turn = uniform(0, 6.283185307179586), r = std::sqrt(1 - z * z);
        const auto rounded = [](double x) { return Q30::from_raw(std::llround(std::ldexp(x, 30))); };
        return {rounded(r * std::cos(turn)), rounded(r * std::sin(turn)), rounded(z)};
    }

private:
    uint64_t state_;
};

}  // namespace shade16::bounds
