# The program in the README is the app that the boards run, to the letter.
cmake_minimum_required(VERSION 3.25)

file(READ ${SOURCE}/README.md readme)
foreach(file IN ITEMS turntable_scene.hpp turntable.cpp)
  file(READ ${SOURCE}/firmware/apps/${file} program)
  string(FIND "${readme}" "```cpp\n${program}```" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "README.md does not show firmware/apps/${file} as it is: paste the file between cpp fences.")
  endif()
endforeach()
