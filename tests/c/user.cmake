# tests/c/user, a project of its own, built for a Cortex-M0+ with C99: prints what the library takes of flash, by its terms.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
shade16_skip_without_program(arm-none-eabi-gcc)
set(RUN_TIMEOUT 280)
set(programs full small shiny)
set(levels Os)
if(ALL)  # what docs/c.md quotes
  list(APPEND programs luma highp_full)
  set(levels Os O2)
endif()

# bytes(<level> <program> <result>): code and constants.
function(bytes level program result)
  shade16_run(sizes arm-none-eabi-size ${SCRATCH}/${level}/${program}_program)
  string(REGEX MATCH "\n *([0-9]+)[ \t]+([0-9]+)" ignored "${sizes}")
  message("${level} ${program}: ${CMAKE_MATCH_1} bytes")
  set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()

foreach(level IN LISTS levels)
  list(TRANSFORM programs APPEND _program OUTPUT_VARIABLE targets)
  shade16_run(ignored ${CMAKE_COMMAND} -S ${SOURCE}/tests/c/user -B ${SCRATCH}/${level} -G Ninja -DSHADE16_DIR=${SOURCE}
    -DCMAKE_TOOLCHAIN_FILE=${SOURCE}/toolchains/arm-none-eabi.cmake -DCMAKE_C_COMPILER=arm-none-eabi-gcc "-DFLAGS=-mcpu=cortex-m0plus -mthumb -${level}")
  shade16_run(ignored ${CMAKE_COMMAND} --build ${SCRATCH}/${level} --parallel 1 --target ${targets})
  foreach(program IN LISTS programs)
    bytes(${level} ${program} ${program}_bytes)
  endforeach()
  # A library of few terms takes less than three fifths of all.
  math(EXPR limit "${full_bytes} * 3 / 5")
  if(small_bytes GREATER limit OR shiny_bytes LESS_EQUAL small_bytes)
    message(FATAL_ERROR "A small selection of terms takes ${small_bytes} bytes, one with highlights ${shiny_bytes}; expected at most ${limit}, and more for highlights.")
  endif()
endforeach()
