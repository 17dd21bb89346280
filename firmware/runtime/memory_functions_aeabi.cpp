// The names by which Clang calls memory_functions.cpp on Arm. Source: Run-time ABI for the Arm Architecture, 5.3.4: memset has another
// order of arguments, and a number says how well aligned the memory is.
#include <stddef.h>

extern "C" {
void* memcpy(void* __restrict to, const void* __restrict from, size_t count);
void* memset(void* to, int value, size_t count);
void* memmove(void* to, const void* from, size_t count);

void __aeabi_memcpy(void* to, const void* from, size_t count) { memcpy(to, from, count); }
void __aeabi_memcpy4(void* to, const void* from, size_t count) { memcpy(to, from, count); }
void __aeabi_memcpy8(void* to, const void* from, size_t count) { memcpy(to, from, count); }
void __aeabi_memmove(void* to, const void* from, size_t count) { memmove(to, from, count); }
void __aeabi_memmove4(void* to, const void* from, size_t count) { memmove(to, from, count); }
void __aeabi_memmove8(void* to, const void* from, size_t count) { memmove(to, from, count); }
void __aeabi_memset(void* to, size_t count, int value) { memset(to, value, count); }
void __aeabi_memset4(void* to, size_t count, int value) { memset(to, value, count); }
void __aeabi_memset8(void* to, size_t count, int value) { memset(to, value, count); }
void __aeabi_memclr(void* to, size_t count) { memset(to, 0, count); }
void __aeabi_memclr4(void* to, size_t count) { memset(to, 0, count); }
void __aeabi_memclr8(void* to, size_t count) { memset(to, 0, count); }
}
