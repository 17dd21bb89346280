# The turntable in Rust, built with whatever rustc is in PATH, must print what the C++ app prints.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
shade16_skip_without_program(rustc)
cmake_path(GET LIBRARY PARENT_PATH folder)
file(MAKE_DIRECTORY ${SCRATCH})
set(PROGRAM ${SCRATCH}/turntable)
shade16_run(ignored ${C_COMPILER} -std=c99 -pedantic -Wall -Wextra -Werror -fPIC -I ${SOURCE}/firmware/c -I ${MODELS} -c ${SOURCE}/tests/c/rust_side.c
  -o ${SCRATCH}/rust_side.o)
shade16_run(ignored ${program_rustc} --edition 2021 -O -D warnings -C linker=${C_COMPILER} -L ${folder} -l static=shade16_c
  -C link-arg=${SCRATCH}/rust_side.o -o ${PROGRAM} ${SOURCE}/tests/c/turntable.rs)
include(${CMAKE_CURRENT_LIST_DIR}/same_text.cmake)
