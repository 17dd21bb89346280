# Clang for WebAssembly of 32 bits without a system.
include(${CMAKE_CURRENT_LIST_DIR}/clang.cmake)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER_TARGET wasm32)
shade16_require(SHADE16_LINKER lld wasm-ld)
set(CMAKE_CXX_LINK_EXECUTABLE "${SHADE16_LINKER} <LINK_FLAGS> <OBJECTS> <LINK_LIBRARIES> -o <TARGET>")
