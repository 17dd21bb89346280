// Code for a Cortex-M0+ on the Cortex-M3 of image AN385, which runs it and has the memory for a whole frame.
#pragma once

#include <boards/mps2.hpp>

namespace shade16 {

struct Board : Mps2 {
    static constexpr const char* name = "qemu_an385_m0plus";
};

}  // namespace shade16
