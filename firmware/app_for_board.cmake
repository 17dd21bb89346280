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
set(console_uart runtime/console_uart.cpp)

# What the processor's own compiler library lacks, and what the chip does before the program runs.
file(GLOB compiler_functions runtime/compiler_functions_${BOARD_STARTUP}.cpp)
if(BOARD_CHIP)
  file(GLOB chip mcu/${BOARD_CHIP}/*.cpp)
endif()

set_source_files_properties(runtime/memory_functions.cpp PROPERTIES
  COMPILE_OPTIONS "-fno-builtin;-fno-tree-loop-distribute-patterns")

# shade16_add_runtime(<name> <console> [<source>...])
function(shade16_add_runtime name console)
  add_library(${name} OBJECT runtime/startup_${BOARD_STARTUP}.cpp runtime/board_memory.cpp runtime/memory_functions.cpp
                             runtime/console.cpp runtime/cycles_${BOARD_STARTUP}.cpp ${console_${console}} ${compiler_functions} ${ARGN})
  target_link_libraries(${name} PUBLIC shade16_board PRIVATE shade16_warnings)
endfunction()

# `shade16_runtime` is for images that the emulator runs. Where it has neither the board's panel nor its clocks, they have another console
# and show nothing, and each app has a second image, <app>_panel, for the board itself.
if(BOARD_EMULATED_CONSOLE)
  shade16_add_runtime(shade16_runtime ${BOARD_EMULATED_CONSOLE})
  target_compile_definitions(shade16_runtime PUBLIC SHADE16_NO_PANEL)
  shade16_add_runtime(shade16_panel_runtime ${BOARD_CONSOLE} ${chip})
else()
  shade16_add_runtime(shade16_runtime ${BOARD_CONSOLE} ${chip})
endif()

# An image of the board. The compiler's own library comes last: it serves every object before it.
function(shade16_add_image_with runtime name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE ${runtime} shade16_warnings gcc)
  set_target_properties(${name} PROPERTIES
    SUFFIX .elf
    CROSSCOMPILING_EMULATOR "${BOARD_EMULATOR}"
    LINK_DEPENDS "${SHADE16_BOARDS_DIR}/${BOARD}/memory.ld;${PROJECT_SOURCE_DIR}/firmware/runtime/sections.ld")
endfunction()
function(shade16_add_image name source)
  shade16_add_image_with(shade16_runtime ${name} ${source})
endfunction()

function(shade16_build_app name source)
  shade16_add_image(${name} ${source})
  set(flashed ${name})
  if(BOARD_EMULATED_CONSOLE)
    set(flashed ${name}_panel)
    shade16_add_image_with(shade16_panel_runtime ${flashed} ${source})
    set_property(GLOBAL APPEND PROPERTY SHADE16_PANEL_IMAGES ${flashed})
  endif()
  target_link_options(${flashed} PRIVATE LINKER:--print-memory-usage)
  shade16_add_binary(${flashed})
  if(BOARD_UF2)
    shade16_add_uf2(${flashed})
  endif()
endfunction()

# <name>.bin, what the flash holds.
function(shade16_add_binary name)
  add_custom_command(TARGET ${name} POST_BUILD COMMAND ${CMAKE_OBJCOPY} -O binary $<TARGET_FILE:${name}> ${name}.bin BYPRODUCTS ${name}.bin VERBATIM)
endfunction()

# <name>.uf2, which a Pico takes as a USB drive does a copy.
function(shade16_add_uf2 name)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/scripts/boards/uf2.py ${name}.bin ${name}.uf2 BYPRODUCTS ${name}.uf2 VERBATIM)
endfunction()

function(shade16_build_scene name source)
  shade16_add_image(${name} ${source})
endfunction()
