# -DBOARD=<name> reads boards/<name>/board.cmake, which names the toolchain and its flags. Included before project().
set(BOARD "" CACHE STRING "A folder under boards/; empty builds for this computer")
set(SHADE16_BOARDS_DIR ${CMAKE_CURRENT_SOURCE_DIR}/boards)

# A board is a folder that holds a board.cmake. Nothing else has to be told about it.
file(GLOB board_files RELATIVE ${SHADE16_BOARDS_DIR} CONFIGURE_DEPENDS ${SHADE16_BOARDS_DIR}/*/board.cmake)
list(TRANSFORM board_files REPLACE "/board.cmake$" "" OUTPUT_VARIABLE SHADE16_BOARDS)

if(BOARD)
  if(NOT BOARD IN_LIST SHADE16_BOARDS)
    include(${CMAKE_CURRENT_LIST_DIR}/nearest.cmake)
    shade16_nearest_first("${BOARD}" SHADE16_BOARDS)
    list(JOIN SHADE16_BOARDS ", " known)
    message(FATAL_ERROR "No board '${BOARD}'. Boards: ${known}.")
  endif()
  include(${SHADE16_BOARDS_DIR}/${BOARD}/board.cmake)
  set(CMAKE_TOOLCHAIN_FILE ${CMAKE_CURRENT_LIST_DIR}/${BOARD_TOOLCHAIN}.cmake)
endif()
