// The shininess kernel that a tier's promise asks for: a window a material, or the shared pair of tables.
#pragma once

#include "shade16/num/shininess_shared.hpp"
#include "shade16/num/shininess_window.hpp"

namespace shade16 {

namespace detail {
template <PrecisionTier Tier, bool Wide = Arithmetic<Tier>::wide>
struct ShininessOf {
    using type = ShininessShared;
};
template <PrecisionTier Tier>
struct ShininessOf<Tier, false> {
    using type = ShininessWindow<window_segments(Arithmetic<Tier>::shininess_max_error)>;
};
}  // namespace detail

template <PrecisionTier Tier>
using Shininess = typename detail::ShininessOf<Tier>::type;

/// The kernel for one exponent: at compile time for a scene in flash, at run time for one from a file, with equal bits.
template <PrecisionTier Tier>
constexpr Shininess<Tier> shininess(Q16 exponent) {
    return Shininess<Tier>::build(exponent, Arithmetic<Tier>::shininess_max_error);
}

}  // namespace shade16
