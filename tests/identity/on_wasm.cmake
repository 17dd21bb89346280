# WebAssembly: clang and its linker alone, run by node.
set(program ${CMAKE_CURRENT_BINARY_DIR}/identity/wasm32/identity.wasm)
shade16_identity_build(wasm32 PROGRAM ${program} COMPILER clang++ TOOLCHAIN clang-wasm32
  SOURCES ${identity_all} tests/identity/main_wasm.cpp firmware/runtime/console.cpp firmware/runtime/memory_functions.cpp
  FLAGS -O2 -DSHADE16_QUICK_INPUTS=1000000 -DSHADE16_SLOW_INPUTS=1000000 -DSHADE16_LARGE_FRAMES
  LINK wasm-ld --no-entry -z stack-size=65536 <objects> -o <program>)
shade16_identity_test(wasm32 PROGRAMS ${program} KINDS kernel frame large_frame LEAST 1000000 NEEDS clang++ wasm-ld node
  EMULATOR node ${CMAKE_CURRENT_SOURCE_DIR}/identity/run_wasm.mjs)
