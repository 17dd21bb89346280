# Runs an image that goes wrong: what it prints must match SENTENCE, and its status must be STATUS. HINT is for
# whoever adds a board.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../../scripts/skip.cmake)

separate_arguments(emulator UNIX_COMMAND "${EMULATOR}")
shade16_skip_without_emulator(${emulator})
execute_process(COMMAND ${emulator} ${IMAGE} OUTPUT_VARIABLE said ERROR_VARIABLE complaint RESULT_VARIABLE status TIMEOUT 60)
if(NOT status STREQUAL STATUS OR NOT said MATCHES "^${SENTENCE}\n$")
  message(FATAL_ERROR "Expected '${SENTENCE}' and status ${STATUS}. The program ended with '${status}' and said:\n${said}${complaint}${HINT}")
endif()
