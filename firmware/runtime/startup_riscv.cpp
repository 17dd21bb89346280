// From reset to main() on RISC-V in machine mode, and one sentence when the processor traps.
#include <runtime/allow_csr.hpp>
#include <runtime/ending.hpp>
#include <runtime/variables.hpp>

int main();

extern "C" {

[[noreturn]] __attribute__((used)) void shade16_start() {
    shade16::initialise_variables();
    shade16::end_program(main());
}

[[noreturn]] __attribute__((used)) void shade16_report_trap(uint32_t address, uint32_t cause, const uint32_t* stack) {
    shade16::end_by_fault(address, cause, stack);
}

// The stack may be what broke, and nobody comes back: the report gets a fresh one.
[[noreturn]] __attribute__((naked, used, aligned(4))) void shade16_trap() {
    asm(".option push\n" ALLOW_CSR
        "csrr a0, mepc\n"
        "csrr a1, mcause\n"
        ".option pop\n"
        "mv a2, sp\n"
        "la sp, shade16_stack_end\n"
        "j shade16_report_trap\n");
}

// Where these machines begin: sections.ld puts it at the start of the flash.
[[noreturn]] __attribute__((naked, used, section(".vectors"))) void shade16_reset() {
    asm(".option push\n.option norelax\n"
        "la gp, __global_pointer$\n"
        ".option pop\n"
        "la sp, shade16_stack_end\n"
        "la t0, shade16_trap\n"
        ".option push\n" ALLOW_CSR
        "csrw mtvec, t0\n"
        ".option pop\n"
        "j shade16_start\n");
}
}
