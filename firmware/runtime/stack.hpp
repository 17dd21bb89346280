// The stack lies between the last variable and the end of RAM. A start-up paints it, so that one can tell later how far down it went, and
// whether it went into the variables: then its last word has lost its paint. (Unless a function leaves out that word, as one with a large
// array may: nothing here sees that.)
#pragma once

#include <stdint.h>

extern "C" {
extern uint32_t shade16_bss_end[], shade16_stack_end[];
}

namespace shade16 {

constexpr uint32_t stack_paint = 0x5AC35AC3;  // as an address it is no memory, as a number no usual one

/// Inlined, so that nothing is below the stack pointer while it is painted there.
[[gnu::always_inline]] inline void paint_stack() {
    volatile uint32_t* stack_pointer;
#if defined(__riscv)
    asm volatile("mv %0, sp" : "=r"(stack_pointer));
#elif defined(__xtensa__)
    asm volatile("mov %0, a1" : "=r"(stack_pointer));
#else
    asm volatile("mov %0, sp" : "=r"(stack_pointer));
#endif
    for (volatile uint32_t* word = shade16_bss_end; word < stack_pointer; ++word) *word = stack_paint;
}

/// Whether the stack has reached the variables.
inline bool is_stack_full() { return *static_cast<volatile uint32_t*>(shade16_bss_end) != stack_paint; }

inline uint32_t stack_bytes() { return static_cast<uint32_t>(shade16_stack_end - shade16_bss_end) * sizeof(uint32_t); }

/// How many bytes were ever used: all above the lowest word that has lost its paint.
inline uint32_t stack_bytes_used() {
    const volatile uint32_t* word = shade16_bss_end;
    while (word < shade16_stack_end && *word == stack_paint) ++word;
    return static_cast<uint32_t>(shade16_stack_end - word) * sizeof(uint32_t);
}

}  // namespace shade16
