# The board's image, where there is an emulator to run it. A Cortex-M0 makes a logarithm of 48 64-bit products a million times in a quarter
# of a minute, so slow kernels get a tenth of the arguments, unless somebody asks for all.
if(NOT BOARD_EMULATOR OR BOARD_TOO_SMALL_FOR_IDENTITY)
  return()
endif()

# Said here, and not by the linker a minute later.
file(READ ${SHADE16_BOARDS_DIR}/${BOARD}/memory.ld memory)
if(memory MATCHES "FLASH[^\n]*LENGTH *= *([0-9]+)K" AND CMAKE_MATCH_1 LESS 160)
  message(FATAL_ERROR "boards/${BOARD}/memory.ld has ${CMAKE_MATCH_1} KB of flash, and the kernels of docs/identity.md take 142 KB of code beside their runtime; "
                      "expected set(BOARD_TOO_SMALL_FOR_IDENTITY ON) in its board.cmake.")
endif()

set(quick_inputs 1000000)
set(slow_inputs 100000)
if(BOARD_IDENTITY_INPUTS)  # a slow machine
  set(quick_inputs ${BOARD_IDENTITY_INPUTS})
  set(slow_inputs 1000)
endif()
if(SHADE16_IDENTITY_ALL)
  set(quick_inputs 1000000)
  set(slow_inputs 1000000)
endif()

list(TRANSFORM identity_all PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE sources)
set(kinds kernel frame)
if(BOARD_SCENES)
  list(APPEND kinds large_frame)
else()
  list(FILTER sources EXCLUDE REGEX "large_frames")
endif()

shade16_add_image(identity ${PROJECT_SOURCE_DIR}/tests/identity/main.cpp)
target_sources(identity PRIVATE ${sources})
target_compile_definitions(identity PRIVATE SHADE16_QUICK_INPUTS=${quick_inputs} SHADE16_SLOW_INPUTS=${slow_inputs} $<$<BOOL:${BOARD_SCENES}>:SHADE16_LARGE_FRAMES>)
shade16_identity_test(${BOARD} PROGRAMS $<TARGET_FILE:identity> KINDS ${kinds} LEAST ${slow_inputs} EMULATOR ${BOARD_EMULATOR})
