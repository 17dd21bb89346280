// EXPECT: no arithmetic of this engine holds this promise: the smallest is 0.006 levels
#include "shade16/num/tier.hpp"

using shade16::operator""_levels;

struct too_good {
    static constexpr shade16::Promise promise{0.001_levels, 0.001_levels};
    static constexpr shade16::Stepping stepping = shade16::Stepping::exact;
};
static_assert(shade16::Arithmetic<too_good>::wide);
