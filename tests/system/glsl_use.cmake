# What a program does not use of GLSL's vocabulary takes no byte of it; all of it needs neither floating point, nor 64-bit
# division, nor the heap. Compiles SOURCE/tests/system/glsl_use.cpp with COMPILER and FLAGS and reads the symbols with NM.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
shade16_skip_without_program(${COMPILER})
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
file(MAKE_DIRECTORY ${SCRATCH})

function(compile use)
  shade16_run(ignored ${COMPILER} ${flags} -std=c++20 -O2 -ffunction-sections -fdata-sections -ffreestanding -fno-exceptions
    -fno-rtti -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Werror -D${use} -I ${SOURCE}/core/include -c ${SOURCE}/tests/system/glsl_use.cpp -o ${SCRATCH}/${use}.o)
endfunction()

# expect_symbols(<use> <name>...): the functions and tables in the object file, their arguments left out.
function(expect_symbols use)
  compile(${use})
  shade16_run(symbols ${NM} --defined-only --format=posix --demangle ${SCRATCH}/${use}.o)
  string(REGEX MATCHALL "[^\n]+" symbols "${symbols}")
  list(FILTER symbols EXCLUDE REGEX "^\\$|narrow::multiply")  # where code begins; a core's missing instruction
  list(TRANSFORM symbols REPLACE "[(].*| [A-Za-z] .*" "")
  list(SORT symbols)
  if(NOT symbols STREQUAL "${ARGN}")
    message(SEND_ERROR "A program with ${use} of the vocabulary contains '${symbols}', where '${ARGN}' was expected.")
  endif()
endfunction()

expect_symbols(NOTHING)
expect_symbols(ARITHMETIC facing)
expect_symbols(ROOT root shade16::detail::rsqrt_table_49 shade16::rounded_root)

compile(EVERYTHING)
shade16_run(sizes ${NM} --size-sort --print-size --demangle --radix=d ${SCRATCH}/EVERYTHING.o)
foreach(name IN ITEMS glsl::pow glsl::tan glsl::mod glsl::smoothstep detail::roots_of_half)
  if(NOT sizes MATCHES "${name}")
    message(SEND_ERROR "The program that uses everything does not contain ${name}: this test looks at the wrong thing.")
  endif()
endforeach()
message("${sizes}")
set(IMAGE ${SCRATCH}/EVERYTHING.o)
include(${CMAKE_CURRENT_LIST_DIR}/../budget/forbidden_symbols.cmake)
