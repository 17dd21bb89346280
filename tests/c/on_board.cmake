# The turntable in C as an image: compiled by the board's C compiler, linked with the library and this project's own runtime alone.
add_executable(turntable_c ${CMAKE_CURRENT_LIST_DIR}/turntable.c ${CMAKE_CURRENT_LIST_DIR}/print_board.cpp)
shade16_c_turntable(turntable_c shade16_c rgb565 ${SHADE16_C_LARGE_SCREEN})
target_link_libraries(turntable_c PRIVATE shade16_runtime shade16_compiler_library)
set_target_properties(turntable_c PROPERTIES SUFFIX .elf LINKER_LANGUAGE C CROSSCOMPILING_EMULATOR "${BOARD_EMULATOR}")
set_property(GLOBAL APPEND PROPERTY SHADE16_IMAGES turntable_c)
