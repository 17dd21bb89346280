# The turntable in C as an image: compiled by the board's C compiler, linked with the library and this project's own runtime alone.
add_executable(turntable_c ${CMAKE_CURRENT_LIST_DIR}/turntable.c ${CMAKE_CURRENT_LIST_DIR}/print_board.cpp)
shade16_c_turntable(turntable_c shade16_c rgb565 ${SHADE16_C_LARGE_SCREEN})
target_link_libraries(turntable_c PRIVATE shade16_runtime gcc)
set_target_properties(turntable_c PROPERTIES SUFFIX .elf LINKER_LANGUAGE C CROSSCOMPILING_EMULATOR "${BOARD_EMULATOR}")

shade16_add_script_test(forbidden_symbols.turntable_c LABEL budget SCRIPT budget/forbidden_symbols.cmake
  NM=${CMAKE_NM} IMAGE=$<TARGET_FILE:turntable_c>)
