// MPS2 with image AN500: a Cortex-M7. Its FPU stays off: the engine does not need one.
#pragma once

#include <boards/mps2.hpp>

namespace shade16 {

struct Board : Mps2 {
    static constexpr const char* name = "qemu_mps2_an500";
};

}  // namespace shade16
