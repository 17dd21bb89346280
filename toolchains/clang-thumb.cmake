# Clang for bare-metal Arm: Thumb code, unless a board's flags say otherwise.
include(${CMAKE_CURRENT_LIST_DIR}/clang_beside_gcc.cmake)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER_TARGET thumbv6m-none-eabi)
shade16_require(gcc gcc-arm-none-eabi arm-none-eabi-gcc)
shade16_use_gnu_tools(${gcc})
