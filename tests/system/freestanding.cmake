# Compiles the core with COMPILER and FLAGS as a machine without a C++ library would: with ALONE, each header by itself
# (which does not depend on the machine), otherwise all in one go (which is ten times faster).
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
shade16_skip_without_program(${COMPILER})

file(GLOB_RECURSE headers RELATIVE ${SOURCE}/core/include ${SOURCE}/core/include/*.hpp)
if(NOT headers)
  message(FATAL_ERROR "There is no header under core/include: this test would pass without compiling anything.")
endif()

file(REMOVE_RECURSE ${SCRATCH})
set(sources "")
foreach(header IN LISTS headers)
  string(REPLACE "/" "_" stem "${header}")
  if(NOT ALONE)
    set(stem core)
  endif()
  file(APPEND ${SCRATCH}/${stem}.cpp "#include <${header}>\n#include <${header}>\n")  # twice: it has a guard
  list(APPEND sources ${SCRATCH}/${stem}.cpp)
endforeach()
list(REMOVE_DUPLICATES sources)

separate_arguments(flags UNIX_COMMAND "${FLAGS}")
execute_process(
  COMMAND ${COMPILER} ${flags} -std=c++20 -ffreestanding -nostdinc++ -fno-exceptions -fno-rtti -Wall -Wextra -Werror
          -fsyntax-only -I ${SOURCE}/core/include ${sources}
  ERROR_VARIABLE complaint RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  string(REPLACE "\n" "\n  " complaint "\n${complaint}")  # CMake leaves indented lines as they are
  message(FATAL_ERROR "The core does not compile with ${COMPILER} ${FLAGS}:${complaint}")
endif()
