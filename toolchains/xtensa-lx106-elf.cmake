# GCC for the ESP8266's processor.
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
set(CMAKE_SYSTEM_PROCESSOR xtensa)
shade16_require(CMAKE_CXX_COMPILER gcc-xtensa-lx106 xtensa-lx106-elf-g++)
