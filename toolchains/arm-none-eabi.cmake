# GCC for bare-metal Arm.
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
set(CMAKE_SYSTEM_PROCESSOR arm)
shade16_require(CMAKE_CXX_COMPILER gcc-arm-none-eabi arm-none-eabi-g++)
