# The engine for C and for Rust on this computer. Included after programs.cmake.
set(c_dir ${CMAKE_CURRENT_LIST_DIR})

# shade16_c_same_frames(<library> <format> <board> <screen>...): the turntable in C prints what the C++ app with that board's screen prints.
function(shade16_c_same_frames library format board)
  set(name c_turntable_${format})
  add_executable(${name} ${c_dir}/turntable.c ${c_dir}/print_host.c)
  shade16_c_turntable(${name} ${library} ${format} ${ARGN})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE C)
  add_dependencies(checks ${name} turntable_${board})
  shade16_add_script_test(c.frames.${format} LABEL c SCRIPT c/same_text.cmake
    PROGRAM=$<TARGET_FILE:${name}> EXPECTED=$<TARGET_FILE:turntable_${board}>)
endfunction()

shade16_c_same_frames(shade16_c rgb565 qemu_mps2_an385 ${SHADE16_C_LARGE_SCREEN})
shade16_c_same_frames(shade16_c rgb565_swapped pico_ili9341 ${SHADE16_C_LARGE_SCREEN})

# Grey: another pipeline, hence another library.
shade16_add_c_library(shade16_c_luma CHANNELS luma)
target_link_libraries(shade16_c_luma PRIVATE shade16_warnings)
shade16_c_same_frames(shade16_c_luma gray4 qemu_lm3s6965evb WIDTH 128 HEIGHT 64 ROWS 16 PIXEL uint8_t PIXELS_A_BYTE 2 MODEL_SIZE 8 BACKGROUND 0x101820)
shade16_c_same_frames(shade16_c_luma mono1_dithered qemu_lm3s811evb WIDTH 96 HEIGHT 16 ROWS 8 PIXEL uint8_t PIXELS_A_BYTE 8 MODEL_SIZE 7 BACKGROUND 0)

foreach(compiler IN ITEMS gcc clang)
  shade16_add_script_test(c.header.${compiler} LABEL c SCRIPT c/header.cmake SOURCE=${PROJECT_SOURCE_DIR} COMPILER=${compiler})
endforeach()

# Sanitizers bring a library of their own.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  shade16_add_script_test(c.undefined_symbols LABEL c SCRIPT c/undefined_symbols.cmake NM=${CMAKE_NM} LIBRARY=$<TARGET_FILE:shade16_c>)
  shade16_add_script_test(c.frames.rust LABEL c SCRIPT c/rust.cmake SOURCE=${PROJECT_SOURCE_DIR} SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/rust
    C_COMPILER=${CMAKE_C_COMPILER} MODELS=${SHADE16_C_MODELS} LIBRARY=$<TARGET_FILE:shade16_c> EXPECTED=$<TARGET_FILE:turntable_qemu_mps2_an385>)
endif()

# The C program as an image of the boards that say BOARD_C.
function(shade16_c_on_board board)
  set(BOARD_C)
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  if(BOARD_C)
    list(JOIN BOARD_EMULATOR " " emulator)
    shade16_add_script_test(c.frames.${board} LABEL boards SCRIPT boards/same_on_board.cmake BOARD=${board} "EMULATOR=${emulator}"
      IMAGE=${SHADE16_BOARD_BUILDS}/${board}/tests/turntable_c.elf HOST_PROGRAM=$<TARGET_FILE:turntable_${board}>)
    add_dependencies(checks turntable_${board})
  endif()
endfunction()
get_property(boards GLOBAL PROPERTY SHADE16_EMULATED_BOARDS)
foreach(board IN LISTS boards)
  shade16_c_on_board(${board})
endforeach()

if(COMMAND shade16_add_test)
  shade16_add_test(c_tests unit ${c_dir}/statuses_test.cpp ${c_dir}/same_scene_test.cpp)
  target_link_libraries(c_tests PRIVATE shade16_c)
  target_compile_definitions(c_tests PRIVATE SHADE16_DOCS="${PROJECT_SOURCE_DIR}/docs")
  shade16_add_c_library(shade16_c_small TERMS perspective gouraud directional ambient diffuse)
  target_link_libraries(shade16_c_small PRIVATE shade16_warnings)
  shade16_add_test(c_terms_tests unit ${c_dir}/terms_test.cpp)
  target_link_libraries(c_terms_tests PRIVATE shade16_c_small)
endif()

# A project of its own, for a Cortex-M0+.
shade16_add_script_test(c.user_project LABEL c SCRIPT c/user.cmake SOURCE=${PROJECT_SOURCE_DIR} SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/c_user)
set_tests_properties(c.user_project PROPERTIES TIMEOUT 300)
