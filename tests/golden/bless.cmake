# Rewrites frames.txt from this computer's programs: cmake -P bless.cmake -- <app> <board> <program> [...]
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/frames.cmake)

set(text "# <app> <board> <frame> <hash>. Written by 'bless'; all boards and compilers must draw the same.\n")

set(at 4)  # after cmake -P bless.cmake --
while(at LESS CMAKE_ARGC)
  math(EXPR at_board "${at} + 1")
  math(EXPR at_program "${at} + 2")
  shade16_run(printed ${CMAKE_ARGV${at_program}})
  shade16_frames(${CMAKE_ARGV${at}} ${CMAKE_ARGV${at_board}} "${printed}" rows)
  list(JOIN rows "\n" lines)
  string(APPEND text "${lines}\n")
  math(EXPR at "${at} + 3")
endwhile()

file(WRITE ${CMAKE_CURRENT_LIST_DIR}/frames.txt "${text}")
