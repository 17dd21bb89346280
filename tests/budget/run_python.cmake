# Runs a Python program with ARGUMENTS; if IMAGE is given, it is about the emulated board that IMAGE was built for.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
shade16_skip_without_program(python3)
if(IMAGE)
  shade16_skip_without_program(qemu-system-arm)
  shade16_skip_without_program(arm-none-eabi-readelf)
  shade16_skip_without_file(${IMAGE} "build the board with 'cmake --workflow --preset <board>'.")
endif()

separate_arguments(arguments UNIX_COMMAND "${ARGUMENTS}")
shade16_run(printed python3 -B ${PROGRAM} ${arguments})
message("${printed}")
