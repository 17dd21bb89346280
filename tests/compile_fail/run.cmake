# Compiles SOURCE with COMPILER and expects a refusal that contains the text after its `// EXPECT: ` comment. The words
# around it differ from compiler to compiler; that text is what a user must be able to read.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
shade16_skip_without_program(${COMPILER})

file(STRINGS ${SOURCE} expectation REGEX "^// EXPECT: " LIMIT_COUNT 1)
if(NOT expectation)
  message(FATAL_ERROR "${SOURCE} does not say which message it expects: it lacks a line that begins with '// EXPECT: '.")
endif()
string(REGEX REPLACE "^// EXPECT: " "" expectation "${expectation}")

execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I ${INCLUDE} -I ${INCLUDE}/../../firmware ${SOURCE}
  OUTPUT_VARIABLE printed ERROR_VARIABLE complaint RESULT_VARIABLE status)
if(status EQUAL 0)
  message(FATAL_ERROR "${COMPILER} compiles ${SOURCE}, which it should refuse.")
endif()
string(FIND "${printed}${complaint}" "${expectation}" position)
if(position EQUAL -1)
  string(REPLACE "\n" "\n  " complaint "\n${complaint}")  # CMake leaves indented lines as they are
  message(FATAL_ERROR "${COMPILER} refuses ${SOURCE}, but does not say '${expectation}':${complaint}")
endif()
