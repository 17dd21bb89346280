# The picture on an emulated board's display, against the one that the same app draws on this computer: see screen_dump.py.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)

separate_arguments(emulator UNIX_COMMAND "${EMULATOR}")
separate_arguments(bits UNIX_COMMAND "${BITS}")
list(GET emulator 0 program)
shade16_skip_without_program(${program})
shade16_skip_without_program(python3)
shade16_skip_without_file(${IMAGE} "build it with 'cmake --workflow --preset ${BOARD}'.")

execute_process(
  COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/screen_dump.py --bits ${bits} --program ${HOST_PROGRAM} --image ${IMAGE} -- ${emulator}
  RESULT_VARIABLE status OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
if(EXPECTED_ERROR)
  string(FIND "${printed}" "${EXPECTED_ERROR}" at)
  if(status EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "Expected the error '${EXPECTED_ERROR}', but it ended with ${status} and printed:\n${printed}")
  endif()
elseif(NOT status EQUAL 0)
  message(FATAL_ERROR "${BOARD}: ${printed}")
endif()
message("${printed}")
