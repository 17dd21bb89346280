// Hands the sizes in board.hpp to the linker as symbols, so that sections.ld can hold them against memory.ld.
#include <board.hpp>

extern "C" __attribute__((used)) void shade16_board_memory() {
    // %c prints a constant without the assembler's '#'.
    asm(".global shade16_board_flash_bytes\n.set shade16_board_flash_bytes, %c0\n"
        ".global shade16_board_ram_bytes\n.set shade16_board_ram_bytes, %c1\n" ::"i"(shade16::Board::flash_bytes),
        "i"(shade16::Board::ram_bytes));
}
