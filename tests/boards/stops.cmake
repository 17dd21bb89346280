# An image that cannot work where it runs must say why and end with a failure, and not hang.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)

separate_arguments(emulator UNIX_COMMAND "${EMULATOR}")
shade16_skip_without_program(python3)
list(GET emulator 0 program)
shade16_skip_without_emulator(${program})
execute_process(COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/until_exit.py ${emulator} ${IMAGE} RESULT_VARIABLE status OUTPUT_VARIABLE printed ERROR_QUIET)
if(status EQUAL 0 OR NOT printed STREQUAL "${SENTENCE}\n")
  message(FATAL_ERROR "${IMAGE} ended with ${status} and printed '${printed}'; expected a failure and '${SENTENCE}'.")
endif()
