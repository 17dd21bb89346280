# Builds a board's turntable with the compiler that the board does not name, and compares what it prints with this computer's program.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/tools.cmake)

shade16_tool_names(programs packages)
foreach(program IN LISTS programs)
  shade16_skip_without_program(${program})
endforeach()
shade16_run(ignored ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/../.. -B ${BUILD} -G Ninja -DBOARD=${BOARD} -DTOOLCHAIN=${TOOLCHAIN})
shade16_run(ignored ${CMAKE_COMMAND} --build ${BUILD} --target turntable --parallel 1)
set(IMAGE ${BUILD}/firmware/turntable.elf)
include(${CMAKE_CURRENT_LIST_DIR}/../boards/same_on_board.cmake)
