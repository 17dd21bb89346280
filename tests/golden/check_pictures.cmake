# Holds the frames of PROGRAM against the pictures in frames/, pixel by pixel: what a hash cannot show.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/draw_pictures.cmake)

shade16_pictures(check ${TOOL} ${APP} ${BOARD} ${PROGRAM} ${SCRATCH} ${CHANGED} status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "A frame is not as in tests/golden/frames. If it looks right, run 'cmake --build --preset host --target bless_frames'.")
endif()

# They are in the repository for good, with every frame that they ever were.
set(limit_bytes 358400)
set(sum 0)
file(GLOB pictures ${CMAKE_CURRENT_LIST_DIR}/frames/*.png)
foreach(picture IN LISTS pictures)
  file(SIZE ${picture} bytes)
  math(EXPR sum "${sum} + ${bytes}")
endforeach()
if(sum GREATER limit_bytes)
  message(FATAL_ERROR "The pictures in tests/golden/frames take ${sum} bytes; expected at most ${limit_bytes}.")
endif()
