// Xtensa's simulator call: the program asks the simulator to print for it and to end it.
// Source: Xtensa Instruction Set Architecture Reference Manual, SIMCALL; QEMU, "Xtensa semihosting".
#include <stdint.h>
#include <runtime/console.hpp>

namespace shade16::console {

namespace {

constexpr int32_t sys_exit = 1, sys_write = 4;

void call(int32_t operation, int32_t first, const void* second, int32_t third) {
    register int32_t a2 asm("a2") = operation;
    register int32_t a3 asm("a3") = first;
    register const void* a4 asm("a4") = second;
    register int32_t a5 asm("a5") = third;
    asm volatile("simcall" : "+r"(a2), "+r"(a3) : "r"(a4), "r"(a5) : "memory");
}

}  // namespace

void print(const char* text) {
    int32_t length = 0;
    while (text[length] != 0) ++length;
    call(sys_write, 1, text, length);
}

void exit(int status) {
    call(sys_exit, status, nullptr, 0);
    for (;;) asm volatile("");
}

}  // namespace shade16::console
