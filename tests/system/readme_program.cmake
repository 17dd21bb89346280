# The program in the README is the app that the boards run, to the letter.
cmake_minimum_required(VERSION 3.25)

file(READ ${SOURCE}/README.md readme)
file(READ ${SOURCE}/firmware/apps/turntable.cpp program)
string(FIND "${readme}" "```cpp\n${program}```" at)
if(at EQUAL -1)
  message(FATAL_ERROR "README.md does not show firmware/apps/turntable.cpp as it is: paste the file between the cpp fences.")
endif()
