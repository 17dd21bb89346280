# What a board.cmake says must be known, must be there, and must name what exists: each mistake is one sentence.

function(shade16_board_mistake words)
  message(FATAL_ERROR "boards/${BOARD}/board.cmake says ${words}")
endfunction()

# shade16_expect_word(<variable> <known>...): its value is one of them.
function(shade16_expect_word variable)
  if(NOT ${variable} IN_LIST ARGN)
    list(JOIN ARGN ", " known)
    shade16_board_mistake("${variable} '${${variable}}'; expected one of ${known}.")
  endif()
endfunction()

# shade16_expect_file(<variable> <folder> <what its files begin with> <glob>): the variable names one of them.
function(shade16_expect_file variable folder prefix glob)
  file(GLOB files RELATIVE ${folder} ${folder}/${glob})
  list(TRANSFORM files REPLACE "^${prefix}(.*)\\.[a-z]+$" "\\1")
  shade16_expect_word(${variable} ${files})
endfunction()

function(shade16_check_board)
  foreach(file IN ITEMS board.hpp memory.ld)
    if(NOT EXISTS ${SHADE16_BOARDS_DIR}/${BOARD}/${file})
      message(FATAL_ERROR "boards/${BOARD} has no ${file}; docs/boards.md, step 1, has one to copy.")
    endif()
  endforeach()

  # A mistyped name would be no mistake at all: what it was to say is left out.
  set(required CORE DISPLAY TOOLCHAIN STARTUP CPU_FLAGS OPTIMIZE)
  set(known ${required} CHIP CONSOLE EMULATOR EMULATED_CONSOLE PANEL_EMULATOR PANEL_STOPS SCREEN_BITS SCREEN_MODEL UF2 FRAMES_OF IDENTITY_INPUTS
            TOO_SMALL_FOR_IDENTITY FORGIVES_ACCESS SOMETHING_BELOW_RAM SCENES C)
  get_cmake_property(variables VARIABLES)
  foreach(variable IN LISTS variables)
    if(variable MATCHES "^BOARD_(.+)" AND NOT CMAKE_MATCH_1 IN_LIST known)
      list(JOIN known ", BOARD_" all)
      shade16_board_mistake("${variable}, which nothing reads; expected one of BOARD_${all}.")
    endif()
  endforeach()
  foreach(name IN LISTS required)
    if("${BOARD_${name}}" STREQUAL "")
      shade16_board_mistake("no BOARD_${name}; expected set(BOARD_${name} ..), as docs/boards.md explains.")
    endif()
  endforeach()

  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  shade16_expect_file(BOARD_TOOLCHAIN ${here} "" *-*.cmake)
  shade16_expect_file(BOARD_STARTUP ${here}/../firmware/runtime startup_ startup_*.cpp)
  if(BOARD_CHIP)
    file(GLOB chips RELATIVE ${here}/../firmware/mcu ${here}/../firmware/mcu/*)
    list(FILTER chips EXCLUDE REGEX "\\.")  # headers alone set no clocks
    shade16_expect_word(BOARD_CHIP ${chips})
  endif()
  foreach(console IN ITEMS BOARD_CONSOLE BOARD_EMULATED_CONSOLE)
    if(${console})
      shade16_expect_word(${console} semihosting uart simcall)
    endif()
  endforeach()
  if(BOARD_FRAMES_OF)
    shade16_expect_word(BOARD_FRAMES_OF ${SHADE16_BOARDS})
  endif()
endfunction()
