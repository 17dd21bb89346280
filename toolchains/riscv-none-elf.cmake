# GCC for bare-metal RISC-V. Debian: gcc-riscv64-unknown-elf, which makes code of 32 bits, too; others call it riscv-none-elf.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv)
find_program(riscv_compiler NAMES riscv64-unknown-elf-g++ riscv-none-elf-g++ riscv32-unknown-elf-g++)
if(NOT riscv_compiler)
  message(FATAL_ERROR "There is no riscv64-unknown-elf-g++ or riscv-none-elf-g++; Debian has it in gcc-riscv64-unknown-elf.")
endif()
set(CMAKE_CXX_COMPILER ${riscv_compiler})
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
