# C programs on shade16.h, for this computer and for boards. C is a language of the tests alone: its compiler is the C++ compiler's own.
if(NOT CMAKE_C_COMPILER)
  string(REGEX REPLACE "clang\\+\\+([^/]*)$" "clang\\1" CMAKE_C_COMPILER ${CMAKE_CXX_COMPILER})
  string(REGEX REPLACE "g\\+\\+([^/]*)$" "gcc\\1" CMAKE_C_COMPILER ${CMAKE_C_COMPILER})
endif()
enable_language(C)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# The teapot as C.
set(SHADE16_C_MODELS ${CMAKE_CURRENT_BINARY_DIR}/c_models)
file(MAKE_DIRECTORY ${SHADE16_C_MODELS})
add_custom_command(OUTPUT ${SHADE16_C_MODELS}/teapot.h
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/scripts/mesh_as_c.py assets/teapot.hpp > ${SHADE16_C_MODELS}/teapot.h
  DEPENDS ${PROJECT_SOURCE_DIR}/scripts/mesh_as_c.py ${PROJECT_SOURCE_DIR}/assets/teapot.hpp
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
add_custom_target(c_models DEPENDS ${SHADE16_C_MODELS}/teapot.h)

# The strictest C there is, and the board's flags where there is a board.
function(shade16_c_options target)
  add_dependencies(${target} c_models)
  target_include_directories(${target} PRIVATE ${SHADE16_C_MODELS})
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:C>:-pedantic -Wall -Wextra -Werror>)
  set_target_properties(${target} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
endfunction()

# firmware/apps/turntable.cpp in C, with the screen of a board.
function(shade16_c_turntable target library format)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "WIDTH;HEIGHT;ROWS;PIXEL;PIXELS_A_BYTE;MODEL_SIZE;BACKGROUND" "")
  shade16_c_options(${target})
  target_link_libraries(${target} PRIVATE ${library})
  target_compile_definitions(${target} PRIVATE SCREEN_WIDTH=${arg_WIDTH} SCREEN_HEIGHT=${arg_HEIGHT} BAND_ROWS=${arg_ROWS} PIXEL=${arg_PIXEL}
    PIXELS_A_BYTE=${arg_PIXELS_A_BYTE} MODEL_SIZE=${arg_MODEL_SIZE} BACKGROUND=${arg_BACKGROUND} DRAW=shade16_draw_${format})
endfunction()

set(SHADE16_C_LARGE_SCREEN WIDTH 320 HEIGHT 240 ROWS 40 PIXEL uint16_t PIXELS_A_BYTE 1 MODEL_SIZE 12 BACKGROUND 0x101820)
