# There is nothing to run the fuzzers with.
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
shade16_skip("libFuzzer is not installed for this compiler (Debian: libclang-rt-dev).")
