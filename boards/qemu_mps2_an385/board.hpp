// MPS2 with image AN385: a Cortex-M3.
#pragma once

#include <boards/mps2.hpp>

namespace shade16 {

struct Board : Mps2 {
    static constexpr const char* name = "qemu_mps2_an385";
};

}  // namespace shade16
