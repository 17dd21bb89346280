// Unit14: signed 16 bits, 14 of them fraction. Unit vectors in lowp and mediump, and normals in flash.
// It holds +1 and -1 exactly, which Q1.15 does not.
#pragma once

#include "shade16/num/bits.hpp"

namespace shade16 {

struct Unit14 {
    int16_t raw = 0;

    static constexpr int fraction_bits = 14;
    static constexpr int32_t one = int32_t{1} << fraction_bits;
    static constexpr Unit14 from_raw(int32_t raw) { return {static_cast<int16_t>(clamp<int32_t>(raw, -32768, 32767))}; }
    friend constexpr bool operator==(Unit14, Unit14) = default;
};

}  // namespace shade16
