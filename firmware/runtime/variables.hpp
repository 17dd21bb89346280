// What a start-up does once the stack stands: it is painted, variables get their values, constructors run. The symbols are sections.ld's;
// only their addresses mean anything.
#pragma once

#include <stdint.h>
#include <runtime/stack.hpp>

extern "C" {
extern uint32_t shade16_data_load[], shade16_data_start[], shade16_data_end[];
extern uint32_t shade16_bss_start[];
extern void (*__init_array_start[])();
extern void (*__init_array_end[])();
}

namespace shade16 {

[[gnu::always_inline]] inline void initialise_variables() {
    paint_stack();
    const uint32_t* from = shade16_data_load;
    for (uint32_t* to = shade16_data_start; to < shade16_data_end;) *to++ = *from++;
    for (uint32_t* to = shade16_bss_start; to < shade16_bss_end;) *to++ = 0;
    for (auto constructor = __init_array_start; constructor != __init_array_end; ++constructor) (*constructor)();
}

}  // namespace shade16
