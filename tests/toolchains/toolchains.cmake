# The files of toolchains/. `tools` are the programs that each needs, in the order in which it asks for them, and their Debian packages.
set(clang clang++=clang)
set(lld ld.lld=lld)
set(arm-none-eabi_tools arm-none-eabi-g++=gcc-arm-none-eabi)
set(riscv-none-elf_tools riscv64-unknown-elf-g++=gcc-riscv64-unknown-elf)
set(xtensa-lx106-elf_tools xtensa-lx106-elf-g++=gcc-xtensa-lx106)
set(clang-thumb_tools ${clang} ${lld} arm-none-eabi-gcc=gcc-arm-none-eabi)
set(clang-riscv32_tools ${clang} ${lld} riscv64-unknown-elf-gcc=gcc-riscv64-unknown-elf)
set(clang-avr_tools ${clang} avr-gcc=gcc-avr)
set(clang-wasm32_tools ${clang} wasm-ld=lld)

# What a processor needs to be told before its compiler makes anything.
set(clang-avr_flags -mmcu=atmega1284p)
set(riscv-none-elf_flags "-march=rv32imac -mabi=ilp32")
set(clang-riscv32_flags "-march=rv32imac -mabi=ilp32")

# What each compiles of the engine: Clang 14 takes its drawing for an AVR not at all (a value of 32 bits is in no register of one), its
# arithmetic it does.
set(clang-avr_source arithmetic)

foreach(toolchain IN ITEMS arm-none-eabi riscv-none-elf xtensa-lx106-elf clang-thumb clang-riscv32 clang-avr clang-wasm32)
  list(JOIN ${toolchain}_tools " " tools)
  set(source drawing)
  if(DEFINED ${toolchain}_source)
    set(source ${${toolchain}_source})
  endif()
  foreach(test IN ITEMS compiles says_what_is_missing)
    shade16_add_script_test(toolchain.${toolchain}.${test} LABEL system SCRIPT toolchains/${test}.cmake
      TOOLCHAIN=${PROJECT_SOURCE_DIR}/toolchains/${toolchain}.cmake "TOOLS=${tools}" "FLAGS=${${toolchain}_flags}" SOURCE=${source}
      NINJA=${CMAKE_MAKE_PROGRAM} SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/toolchains/${toolchain}.${test})
  endforeach()
endforeach()

# A board with the other compiler: the frames are the same.
function(shade16_same_with board toolchain host_program)
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  list(JOIN BOARD_EMULATOR " " emulator)
  list(JOIN ${toolchain}_tools " " tools)
  shade16_add_script_test(same_with_${toolchain}.${board} LABEL boards SCRIPT toolchains/same_frames.cmake
    BOARD=${board} TOOLCHAIN=${toolchain} "TOOLS=${tools}" "EMULATOR=${emulator}" BUILD=${CMAKE_CURRENT_BINARY_DIR}/${toolchain}/${board}
    HOST_PROGRAM=$<TARGET_FILE:${host_program}>)
endfunction()
shade16_same_with(qemu_mps2_an385 clang-thumb turntable_qemu_mps2_an385)
shade16_same_with(qemu_riscv_virt clang-riscv32 turntable_qemu_riscv_virt)

# The compiler of another processor is refused before it says anything about flags.
shade16_add_script_test(toolchain_of_another_processor_is_refused LABEL system SCRIPT toolchains/wrong_toolchain.cmake
  NINJA=${CMAKE_MAKE_PROGRAM} SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/toolchains/wrong)
