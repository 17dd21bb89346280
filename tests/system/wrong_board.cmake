# A typing error in a board's name must stop the configuration, suggest the nearest board first and name the others.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -DBOARD=qemu_micorbit
                OUTPUT_QUIET ERROR_VARIABLE complaint RESULT_VARIABLE status)
if(status EQUAL 0)
  message(FATAL_ERROR "The board 'qemu_micorbit' does not exist, but CMake accepted it.")
endif()

string(REGEX REPLACE "[ \n]+" " " complaint "${complaint}")  # CMake wraps long lines
if(NOT complaint MATCHES "No board 'qemu_micorbit'. Boards: qemu_microbit")
  message(FATAL_ERROR "The message should suggest qemu_microbit first. It was: ${complaint}")
endif()
separate_arguments(boards UNIX_COMMAND "${BOARDS}")
foreach(board IN LISTS boards)
  if(NOT complaint MATCHES "${board}")
    message(FATAL_ERROR "The message should name the board ${board}. It was: ${complaint}")
  endif()
endforeach()
