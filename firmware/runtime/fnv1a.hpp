// FNV-1a in 32 bits: one hash for pixels and for numbers. Source: Fowler, Noll and Vo, draft-eastlake-fnv.
#pragma once

#include <stdint.h>

namespace shade16 {

struct Fnv1a {
    uint32_t value = 2166136261u;

    constexpr void add(uint8_t byte) { value = (value ^ byte) * 16777619u; }
};

}  // namespace shade16
