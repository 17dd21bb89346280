# Tests of the whole: the build itself, and the rules that the core promises to keep.
list(JOIN SHADE16_BOARDS " " boards)
shade16_add_script_test(board_mistakes_are_named LABEL system SCRIPT system/board_mistakes.cmake
  SOURCE=${PROJECT_SOURCE_DIR} WORK=${CMAKE_CURRENT_BINARY_DIR}/board_mistakes)
shade16_add_script_test(wrong_board_is_refused LABEL system SCRIPT system/wrong_board.cmake
  SOURCE=${PROJECT_SOURCE_DIR} BUILD=${CMAKE_CURRENT_BINARY_DIR}/wrong_board "BOARDS=${boards}")

shade16_add_script_test(includes_point_one_way LABEL system SCRIPT system/includes.cmake SOURCE=${PROJECT_SOURCE_DIR})
shade16_add_script_test(core_has_no_floating_point LABEL system SCRIPT system/no_floating_point.cmake
  SOURCE=${PROJECT_SOURCE_DIR})

# What is written down is what there is.
shade16_add_script_test(readme_shows_the_program LABEL system SCRIPT system/readme_program.cmake SOURCE=${PROJECT_SOURCE_DIR})
if(TARGET shade16)
  shade16_add_script_test(baked_assets_are_fresh LABEL system SCRIPT system/baked_assets.cmake SOURCE=${PROJECT_SOURCE_DIR}
    FOLDER=assets ENDING=obj PROGRAM=$<TARGET_FILE:shade16> SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/baked_assets)
  shade16_add_script_test(baked_scenes_are_fresh LABEL system SCRIPT system/baked_assets.cmake SOURCE=${PROJECT_SOURCE_DIR}
    FOLDER=assets/scenes ENDING=toml ALL=ON PROGRAM=$<TARGET_FILE:shade16> SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/baked_scenes)
  shade16_add_script_test(baked_assets.stale_ones_are_found LABEL system SCRIPT system/baked_assets_self_test.cmake
    PROGRAM=$<TARGET_FILE:shade16> SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/baked_assets_self_test)
endif()

# The core with no C++ library, on every kind of machine.
function(shade16_freestanding target alone compiler)
  list(JOIN ARGN " " flags)
  shade16_add_script_test(freestanding.${target} LABEL freestanding SCRIPT system/freestanding.cmake
    SOURCE=${PROJECT_SOURCE_DIR} SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/freestanding/${target} ALONE=${alone}
    COMPILER=${compiler} "FLAGS=${flags}")
endfunction()

shade16_freestanding(host_gcc ON g++)
shade16_freestanding(host_clang ON clang++)
shade16_freestanding(cortex_m0plus_gcc OFF arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb)
shade16_freestanding(cortex_m3_gcc OFF arm-none-eabi-g++ -mcpu=cortex-m3 -mthumb)
# -mgeneral-regs-only turns any floating-point arithmetic into an error.
shade16_freestanding(cortex_m4f_gcc OFF arm-none-eabi-g++ -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
                     -mgeneral-regs-only)
shade16_freestanding(rv32imc_gcc OFF riscv64-unknown-elf-g++ -march=rv32imc -mabi=ilp32)
shade16_freestanding(cortex_m0plus_clang OFF clang++ --target=thumbv6m-none-eabi -mcpu=cortex-m0plus)
shade16_freestanding(rv32imc_clang OFF clang++ --target=riscv32-unknown-elf -march=rv32imc -mabi=ilp32)
shade16_freestanding(wasm32_clang OFF clang++ --target=wasm32-unknown-unknown)
# An int of 16 bits, where careless shifts show. Nothing is linked, so clang need not look for AVR's libraries.
shade16_freestanding(avr_clang OFF clang++ --target=avr -mmcu=atmega328p -Wno-avr-rtlib-linking-quirks)

# GLSL's vocabulary on the two kinds of core: with a long multiply and without.
function(shade16_glsl_use target)
  list(JOIN ARGN " " flags)
  shade16_add_script_test(glsl_takes_only_what_is_used.${target} LABEL freestanding SCRIPT system/glsl_use.cmake
    SOURCE=${PROJECT_SOURCE_DIR} SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/glsl_use/${target} COMPILER=arm-none-eabi-g++
    NM=arm-none-eabi-nm "FLAGS=${flags}")
endfunction()

shade16_glsl_use(cortex_m0plus -mcpu=cortex-m0plus -mthumb)
shade16_glsl_use(cortex_m3 -mcpu=cortex-m3 -mthumb)
