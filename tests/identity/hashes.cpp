// The build says how many arguments quick and slow kernels get, and whether there is the memory for large frames.
#include "tests/identity/hashes.hpp"

#include "tests/identity/frames.hpp"
#include "tests/identity/kernels.hpp"

namespace shade16::identity {

void say_hashes() {
    constexpr Inputs inputs{.quick = SHADE16_QUICK_INPUTS, .slow = SHADE16_SLOW_INPUTS};
    say_number_kernels(inputs);
    say_vector_kernels(inputs);
    say_glsl_kernels(inputs);
    say_frames();
#ifdef SHADE16_LARGE_FRAMES
    say_large_frames();
#endif
}

}  // namespace shade16::identity
