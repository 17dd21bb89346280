// Hashes of what every kernel makes of the same arguments. Three groups, because an AVR's flash does not hold all at once.
#pragma once

#include "tests/identity/kernel_run.hpp"

namespace shade16::identity {

void say_number_kernels(Inputs inputs);
void say_vector_kernels(Inputs inputs);
void say_glsl_kernels(Inputs inputs);

}  // namespace shade16::identity
