#include <stdint.h>
#include <runtime/semihosting.hpp>

namespace shade16::semihosting {

namespace {

constexpr uint32_t sys_write0 = 0x04;
constexpr uint32_t sys_exit_extended = 0x20;
constexpr uint32_t application_exit = 0x20026;

void call(uint32_t operation, const void* argument) {
    register uint32_t r0 asm("r0") = operation;
    register const void* r1 asm("r1") = argument;
    asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory", "cc");
}

}  // namespace

void write(const char* text) { call(sys_write0, text); }

void exit(int status) {
    const uint32_t reason_and_status[] = {application_exit, static_cast<uint32_t>(status)};
    call(sys_exit_extended, reason_and_status);
    for (;;) asm volatile("");  // a debugger may choose to carry on
}

}  // namespace shade16::semihosting
