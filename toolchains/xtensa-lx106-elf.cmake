# GCC for the ESP8266's processor. Debian: gcc-xtensa-lx106.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR xtensa)
set(CMAKE_CXX_COMPILER xtensa-lx106-elf-g++)
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
