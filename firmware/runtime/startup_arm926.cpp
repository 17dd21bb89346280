// From reset to main() on an Arm926 in supervisor mode, and one sentence when the processor faults. The exception vectors are at address
// 0, which is RAM: they are put there first.
#include <runtime/ending.hpp>
#include <runtime/variables.hpp>

int main();

extern "C" {

[[noreturn]] __attribute__((used)) void shade16_start() {
    shade16::initialise_variables();
    shade16::end_program(main());
}

// What the link register is ahead of: the next instruction, or after an access to data, the one behind it.
[[noreturn]] __attribute__((used)) void shade16_report_fault(uint32_t return_address, uint32_t exception, const uint32_t* stack) {
    constexpr uint32_t data_abort = 4;
    shade16::end_by_fault(return_address - (exception == data_abort ? 8 : 4), exception, stack);
}

// Eight entries of two instructions, one for each vector. Every exception has a stack pointer of its own, so the program's is looked up in
// supervisor mode.
[[noreturn]] __attribute__((naked, used)) void shade16_fault() {
    asm(".irp number, 0, 1, 2, 3, 4, 5, 6, 7\n"
        "mov r1, #\\number\n"
        "b 1f\n"
        ".endr\n"
        "1: mov r0, lr\n"
        "msr cpsr_c, #0xD3\n"
        "mov r2, sp\n"
        "ldr sp, =shade16_stack_end\n"
        "b shade16_report_fault\n"
        ".ltorg\n");
}

// Eight times the instruction "load the program counter from 24 bytes further on", and the address that each loads.
[[noreturn]] __attribute__((naked, used, section(".vectors"))) void shade16_reset() {
    asm("mov r0, #0\n"
        "ldr r1, =0xE59FF018\n"
        "ldr r2, =shade16_fault\n"
        "1: str r1, [r0]\n"
        "str r2, [r0, #32]\n"
        "add r0, r0, #4\n"
        "add r2, r2, #8\n"
        "cmp r0, #32\n"
        "bne 1b\n"
        "ldr sp, =shade16_stack_end\n"
        "b shade16_start\n"
        ".ltorg\n");
}
}
