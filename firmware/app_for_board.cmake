# What an app needs to run on a bare machine: the board's processor flags, its memory, and the runtime.
add_library(shade16_board INTERFACE)
target_include_directories(shade16_board INTERFACE ${SHADE16_BOARDS_DIR}/${BOARD} ${CMAKE_CURRENT_SOURCE_DIR}
                                                   ${PROJECT_SOURCE_DIR})
target_compile_options(shade16_board INTERFACE
  ${BOARD_CPU_FLAGS} ${BOARD_OPTIMIZE} -g ${SHADE16_FREESTANDING} "$<$<COMPILE_LANGUAGE:CXX>:${SHADE16_FREESTANDING_CXX}>")
target_link_options(shade16_board INTERFACE
  ${BOARD_CPU_FLAGS} -nostdlib LINKER:--gc-sections
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

# The compiler's library, which comes last on a command line: it serves every object before it. Clang uses GCC's (toolchains/clang_beside_gcc.cmake).
add_library(shade16_compiler_library INTERFACE)
if(SHADE16_GCC)
  execute_process(COMMAND ${SHADE16_GCC} ${BOARD_CPU_FLAGS} -print-libgcc-file-name OUTPUT_VARIABLE libgcc OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  target_link_libraries(shade16_compiler_library INTERFACE ${libgcc})
else()
  target_link_libraries(shade16_compiler_library INTERFACE gcc)
endif()

# What the processor's own compiler library lacks, and what the chip does before the program runs.
file(GLOB compiler_functions runtime/compiler_functions_${BOARD_STARTUP}.cpp)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "arm")
  list(APPEND compiler_functions runtime/memory_functions_aeabi.cpp)
endif()
if(BOARD_CHIP)
  file(GLOB chip mcu/${BOARD_CHIP}/*.cpp)
endif()

set_source_files_properties(runtime/memory_functions.cpp runtime/memory_functions_aeabi.cpp PROPERTIES
  COMPILE_OPTIONS "-fno-builtin;$<$<CXX_COMPILER_ID:GNU>:-fno-tree-loop-distribute-patterns>")

# shade16_add_runtime(<name> <console> [<source>...])
function(shade16_add_runtime name console)
  add_library(${name} OBJECT runtime/startup_${BOARD_STARTUP}.cpp runtime/board_memory.cpp runtime/memory_functions.cpp runtime/ending.cpp
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

# An image of the board.
function(shade16_add_image_with runtime name source)
  set_property(GLOBAL APPEND PROPERTY SHADE16_IMAGES ${name})
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE ${runtime} shade16_warnings shade16_compiler_library)
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
  endif()
  shade16_print_sizes(${flashed})
  shade16_add_binary(${flashed})
  if(BOARD_UF2)
    shade16_add_uf2(${flashed})
  endif()
endfunction()

# What the image's flash and RAM go to, each time that it is linked.
find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT Python3_Interpreter_FOUND)
  message(STATUS "There is no python3, so that nothing is said about the sizes of images; Debian has it in python3.")
endif()
function(shade16_print_sizes name)
  find_package(Python3 QUIET COMPONENTS Interpreter)  # for whoever calls from another folder
  if(Python3_Interpreter_FOUND)
    string(REGEX REPLACE "readelf$" "" tools ${CMAKE_READELF})
    add_custom_command(TARGET ${name} POST_BUILD
      COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/scripts/bench/sizes.py $<TARGET_FILE:${name}> ${tools} VERBATIM)
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
