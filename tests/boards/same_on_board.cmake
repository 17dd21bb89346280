# Runs an app's image under the board's emulator and the same app on this computer: every line must be equal.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)

separate_arguments(emulator UNIX_COMMAND "${EMULATOR}")
shade16_skip_without_emulator(${emulator})
shade16_skip_without_file(${IMAGE} "build it with 'cmake --workflow --preset ${BOARD}'.")

shade16_run(board_text ${emulator} ${IMAGE})
shade16_run(host_text ${HOST_PROGRAM})
if(board_text STREQUAL host_text)
  return()
endif()

# Different, so find the first line that is.
string(REPLACE "\n" ";" board_lines "${board_text}")
string(REPLACE "\n" ";" host_lines "${host_text}")
list(LENGTH board_lines board_count)
list(LENGTH host_lines host_count)
set(at 0)
while(at LESS board_count AND at LESS host_count)
  list(GET board_lines ${at} board_line)
  list(GET host_lines ${at} host_line)
  math(EXPR at "${at} + 1")
  if(NOT board_line STREQUAL host_line)
    message(FATAL_ERROR "Line ${at} differs:\n  ${BOARD}: ${board_line}\n  host: ${host_line}")
  endif()
endwhile()
message(FATAL_ERROR
  "${BOARD} printed ${board_count} lines, the host ${host_count}; the lines that both have are equal.")
