// From reset to main() on an Arm926 in supervisor mode, and one sentence when the processor faults. The exception vectors are at address
// 0, which is RAM: they are put there first.
#include <runtime/console.hpp>
#include <runtime/variables.hpp>

int main();

extern "C" {

[[noreturn]] __attribute__((used)) void shade16_start() {
    shade16::initialise_variables();
    shade16::console::exit(main());
}

[[noreturn]] __attribute__((used)) void shade16_report_fault(uint32_t address) {
    using namespace shade16;
    console::print("The processor stopped near address 0x");
    console::print_hex(address);
    console::print(".\n");
    console::exit(1);
}

// Every exception brings its own, empty stack pointer, and nobody comes back.
[[noreturn]] __attribute__((naked, used)) void shade16_fault() {
    asm("ldr sp, =shade16_stack_end\n"
        "mov r0, lr\n"
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
        "cmp r0, #32\n"
        "bne 1b\n"
        "ldr sp, =shade16_stack_end\n"
        "b shade16_start\n"
        ".ltorg\n");
}
}
