// Hands the sizes in board.hpp to the linker as symbols, so that sections.ld can hold them against memory.ld.
#include <board.hpp>

#if defined(__arm__)
#define CONSTANT(operand) "%c" operand  // without the assembler's '#'
#else
#define CONSTANT(operand) "%" operand
#endif

extern "C" __attribute__((used)) void shade16_board_memory() {
    asm(".global shade16_board_flash_bytes\n.set shade16_board_flash_bytes, " CONSTANT("0") "\n"
        ".global shade16_board_ram_bytes\n.set shade16_board_ram_bytes, " CONSTANT("1") "\n" ::"i"(shade16::Board::flash_bytes),
        "i"(shade16::Board::ram_bytes));
}
