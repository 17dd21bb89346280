// How a tier's shininess kernel takes u and gives its power.
#pragma once

#include "shade16/num/shininess.hpp"

namespace shade16::bounds {

template <class Tier>
struct Kernel {
    static constexpr bool shared = Arithmetic<Tier>::wide;
    static constexpr int u_bits = shared ? 32 : 29, fraction_bits = shared ? 32 : 16;
    static constexpr double bound = Arithmetic<Tier>::shininess_max_error.micro * 1e-6;
};

}  // namespace shade16::bounds
