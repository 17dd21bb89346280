// Xtensa's simulator call: the program asks the simulator to print for it and to end it.
// Source: Xtensa Instruction Set Architecture Reference Manual, SIMCALL; QEMU, "Xtensa semihosting".
#include <stdint.h>
#include <runtime/console.hpp>

namespace shade16::console {

namespace {

constexpr int32_t sys_exit = 1, sys_write = 4, sys_argument_count = 1000, sys_argument_bytes = 1001, sys_arguments = 1002;

int32_t call(int32_t operation, int32_t first, const void* second, int32_t third) {
    register int32_t a2 asm("a2") = operation;
    register int32_t a3 asm("a3") = first;
    register const void* a4 asm("a4") = second;
    register int32_t a5 asm("a5") = third;
    asm volatile("simcall" : "+r"(a2), "+r"(a3) : "r"(a4), "r"(a5) : "memory");
    return a2;
}

}  // namespace

void print(const char* text) {
    int32_t length = 0;
    while (text[length] != 0) ++length;
    call(sys_write, 1, text, length);
}

/// The simulator lays its list of arguments, addresses and then texts, where it is told to.
bool is_told(const char* word) {
    struct {
        const char* first;
        uint32_t rest[31];
    } arguments{};
    if (call(sys_argument_count, 0, nullptr, 0) == 0) return false;
    if (call(sys_argument_bytes, 0, nullptr, 0) > static_cast<int32_t>(sizeof(arguments))) return false;
    call(sys_arguments, static_cast<int32_t>(reinterpret_cast<intptr_t>(&arguments)), nullptr, 0);
    const char* at = arguments.first;
    while (*word != 0 && *at == *word) ++at, ++word;
    return *word == 0 && *at == 0;
}

void exit(int status) {
    call(sys_exit, status, nullptr, 0);
    for (;;) asm volatile("");
}

}  // namespace shade16::console
