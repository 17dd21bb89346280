# What an app needs to run on a bare machine: the board's processor flags, its memory, and the runtime.
add_library(shade16_board INTERFACE)
target_include_directories(shade16_board INTERFACE ${SHADE16_BOARDS_DIR}/${BOARD} ${CMAKE_CURRENT_SOURCE_DIR}
                                                   ${PROJECT_SOURCE_DIR})
target_compile_options(shade16_board INTERFACE
  ${BOARD_CPU_FLAGS} ${BOARD_OPTIMIZE} -g -ffreestanding -fno-exceptions $<$<COMPILE_LANGUAGE:CXX>:-fno-rtti> $<$<COMPILE_LANGUAGE:CXX>:-fno-threadsafe-statics>
  -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections)
target_link_options(shade16_board INTERFACE
  ${BOARD_CPU_FLAGS} -nostdlib -nostartfiles LINKER:--gc-sections
  LINKER:--script=${SHADE16_BOARDS_DIR}/${BOARD}/memory.ld
  LINKER:--script=${CMAKE_CURRENT_SOURCE_DIR}/runtime/sections.ld)
target_link_libraries(shade16_board INTERFACE shade16::core)

# How a board prints and ends: by Arm's semihosting, which RISC-V has, too, unless it says otherwise.
if(NOT BOARD_CONSOLE)
  set(BOARD_CONSOLE semihosting)
endif()
set(console_semihosting runtime/console_semihosting.cpp runtime/semihosting.cpp)
set(console_simcall runtime/console_simcall.cpp)
set(console_rp2040 runtime/console_rp2040.cpp mcu/rp2040/boot.cpp)

# What the processor's own compiler library lacks.
file(GLOB compiler_functions runtime/compiler_functions_${BOARD_STARTUP}.cpp)

add_library(shade16_runtime OBJECT runtime/startup_${BOARD_STARTUP}.cpp runtime/board_memory.cpp runtime/memory_functions.cpp
                                   runtime/console.cpp ${console_${BOARD_CONSOLE}} ${compiler_functions})
target_link_libraries(shade16_runtime PUBLIC shade16_board PRIVATE shade16_warnings)
set_source_files_properties(runtime/memory_functions.cpp PROPERTIES
  COMPILE_OPTIONS "-fno-builtin;-fno-tree-loop-distribute-patterns")

# An image of the board. The compiler's own library comes last: it serves every object before it.
function(shade16_add_image name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE shade16_runtime shade16_warnings gcc)
  set_target_properties(${name} PROPERTIES
    SUFFIX .elf
    CROSSCOMPILING_EMULATOR "${BOARD_EMULATOR}"
    LINK_DEPENDS "${SHADE16_BOARDS_DIR}/${BOARD}/memory.ld;${PROJECT_SOURCE_DIR}/firmware/runtime/sections.ld")
endfunction()

function(shade16_build_app name source)
  shade16_add_image(${name} ${source})
  target_link_options(${name} PRIVATE LINKER:--print-memory-usage)
  if(BOARD_UF2)
    shade16_add_uf2(${name})
  endif()
endfunction()

# <name>.bin, what the flash holds, and <name>.uf2, which a Pico takes as a USB drive does a copy.
function(shade16_add_uf2 name)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${CMAKE_OBJCOPY} -O binary $<TARGET_FILE:${name}> ${name}.bin
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/scripts/boards/uf2.py ${name}.bin ${name}.uf2
    BYPRODUCTS ${name}.bin ${name}.uf2 VERBATIM)
endfunction()

function(shade16_build_scene name source)
  shade16_add_image(${name} ${source})
endfunction()
