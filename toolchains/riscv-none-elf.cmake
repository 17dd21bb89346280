# GCC for bare-metal RISC-V. Debian's makes code of 32 bits, too; others call it riscv-none-elf.
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
set(CMAKE_SYSTEM_PROCESSOR riscv)
shade16_require(CMAKE_CXX_COMPILER gcc-riscv64-unknown-elf riscv64-unknown-elf-g++ riscv-none-elf-g++ riscv32-unknown-elf-g++)
