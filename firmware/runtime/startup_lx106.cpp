// From reset to main() on Xtensa's LX106, which has no register windows, and one sentence when the processor faults.
// Source: Xtensa Instruction Set Architecture Reference Manual, Exception Option; an LX106 has its vectors for exceptions of the kernel, of
// a user and within another 0x30, 0x50 and 0x70 bytes behind VECBASE.
#include <runtime/ending.hpp>
#include <runtime/variables.hpp>

int main();

extern "C" {

[[noreturn]] __attribute__((used)) void shade16_start() {
    shade16::initialise_variables();
    shade16::end_program(main());
}

[[noreturn]] __attribute__((used)) void shade16_report_fault(uint32_t address, uint32_t cause, const uint32_t* stack) {
    shade16::end_by_fault(address, cause, stack);
}
}

// Where the processor begins, and its vectors: the exception mode of a reset is left, so that a fault is none within another. Literals come
// before the code that loads them, so jumps lead over them. Special registers: 231 VECBASE, 230 PS, 177 EPC1, 232 EXCCAUSE.
asm(".section .vectors, \"ax\"\n"
    ".global shade16_reset\n"
    "shade16_reset: j 5f\n"
    ".balign 4\n"
    "1: .word shade16_stack_end\n"
    "2: .word shade16_start\n"
    "3: .word shade16_reset\n"
    "4: .word shade16_report_fault\n"
    ".org 0x30\nj 6f\n"
    ".org 0x50\nj 6f\n"
    ".org 0x70\nj 6f\n"
    "5: l32r a1, 1b\n"
    "l32r a2, 3b\n"
    "wsr a2, 231\n"
    "movi a2, 0\n"
    "wsr a2, 230\n"
    "rsync\n"
    "l32r a0, 2b\n"
    "jx a0\n"
    "6: rsr a2, 177\n"
    "rsr a3, 232\n"
    "mov a4, a1\n"
    "l32r a1, 1b\n"
    "movi a5, 0\n"
    "wsr a5, 230\n"
    "rsync\n"
    "l32r a0, 4b\n"
    "jx a0\n"
    ".text\n");
