# Clang for bare-metal RISC-V of 32 bits.
include(${CMAKE_CURRENT_LIST_DIR}/clang_beside_gcc.cmake)
set(CMAKE_SYSTEM_PROCESSOR riscv)
set(CMAKE_CXX_COMPILER_TARGET riscv32-unknown-elf)
set(CMAKE_CXX_FLAGS_INIT -mno-relax)  # lld 14 shortens no calls, and refuses code that asks for it
shade16_require(gcc gcc-riscv64-unknown-elf riscv64-unknown-elf-gcc riscv-none-elf-gcc riscv32-unknown-elf-gcc)
shade16_use_gnu_tools(${gcc})
