#pragma once

#include <cstdint>

namespace shade16::bounds {

/// One of `of` equal shares of a run, that several machines may divide among themselves.
struct Shard {
    uint64_t number = 0, of = 1;
};

}  // namespace shade16::bounds
