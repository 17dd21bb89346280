# What Clang's toolchains have in common: one compiler makes code for every processor.
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
shade16_require(CMAKE_CXX_COMPILER clang clang++)
