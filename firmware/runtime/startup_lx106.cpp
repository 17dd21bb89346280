// From reset to main() on Xtensa's LX106, which has no register windows. A fault ends the simulator by itself.
#include <runtime/console.hpp>
#include <runtime/variables.hpp>

int main();

extern "C" {

[[noreturn]] __attribute__((used)) void shade16_start() {
    shade16::initialise_variables();
    shade16::console::exit(main());
}
}

// Where the processor begins. Literals come before the code that loads them, so a jump leads over them.
asm(".section .vectors, \"ax\"\n"
    ".global shade16_reset\n"
    "shade16_reset: j 3f\n"
    ".balign 4\n"
    "1: .word shade16_stack_end\n"
    "2: .word shade16_start\n"
    "3: l32r a1, 1b\n"
    "l32r a0, 2b\n"
    "jx a0\n"
    ".text\n");
