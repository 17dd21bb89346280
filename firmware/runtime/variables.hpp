// What a start-up does once the stack stands: variables get their values, constructors run. The symbols are sections.ld's;
// only their addresses mean anything.
#pragma once

#include <stdint.h>

extern "C" {
extern uint32_t shade16_data_load[], shade16_data_start[], shade16_data_end[];
extern uint32_t shade16_bss_start[], shade16_bss_end[], shade16_stack_end[];
extern void (*__init_array_start[])();
extern void (*__init_array_end[])();
}

namespace shade16 {

inline void initialise_variables() {
    const uint32_t* from = shade16_data_load;
    for (uint32_t* to = shade16_data_start; to < shade16_data_end;) *to++ = *from++;
    for (uint32_t* to = shade16_bss_start; to < shade16_bss_end;) *to++ = 0;
    for (auto constructor = __init_array_start; constructor != __init_array_end; ++constructor) (*constructor)();
}

}  // namespace shade16
