# Prints the command that runs an image of the board whose board.cmake is BOARD_FILE.
include(${BOARD_FILE})
list(JOIN BOARD_EMULATOR " " command)
execute_process(COMMAND ${CMAKE_COMMAND} -E echo "${command}")
