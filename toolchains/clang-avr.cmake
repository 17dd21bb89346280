# Clang for AVR, as GCC's for it knows no C++20; GCC links what Clang compiles, with its library.
include(${CMAKE_CURRENT_LIST_DIR}/clang.cmake)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(CMAKE_CXX_COMPILER_TARGET avr)
shade16_require(SHADE16_LINKER gcc-avr avr-gcc)
set(CMAKE_CXX_LINK_EXECUTABLE "${SHADE16_LINKER} <LINK_FLAGS> <OBJECTS> <LINK_LIBRARIES> -o <TARGET>")
list(APPEND SHADE16_FREESTANDING -Wno-avr-rtlib-linking-quirks)  # Clang links nothing here
