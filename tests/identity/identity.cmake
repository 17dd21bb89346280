# One program of kernels and frames on every machine: all must print the hashes of hashes.txt.
set(identity_kernels tests/identity/number_kernels.cpp tests/identity/vector_kernels.cpp tests/identity/glsl_kernels.cpp)
set(identity_frames tests/identity/frames.cpp tests/identity/large_frames.cpp)
set(identity_all ${identity_kernels} ${identity_frames} tests/identity/hashes.cpp)

# shade16_identity_test(<machine> PROGRAMS <file>... KINDS <kind>... LEAST <inputs> [NEEDS <program>...] [EMULATOR <word>...])
function(shade16_identity_test machine)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LEAST" "PROGRAMS;KINDS;NEEDS;EMULATOR")
  foreach(name IN ITEMS PROGRAMS KINDS NEEDS EMULATOR)
    list(JOIN arg_${name} " " ${name})
  endforeach()
  shade16_add_script_test(identity.${machine} LABEL identity SCRIPT identity/check.cmake MACHINE=${machine}
    "PROGRAMS=${PROGRAMS}" "KINDS=${KINDS}" LEAST=${arg_LEAST} "NEEDS=${NEEDS}" "EMULATOR=${EMULATOR}")
  set_tests_properties(identity.${machine} PROPERTIES TIMEOUT 900)  # a minute on a machine at leisure
endfunction()

# Emulated machines are slow.
option(SHADE16_IDENTITY_ALL "A million arguments for every kernel also on emulated boards, ten thousand on the AVR: minutes each" OFF)

if(BOARD)
  include(identity/on_board.cmake)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  include(identity/machine.cmake)
  include(identity/on_host.cmake)
  include(identity/on_wasm.cmake)
  include(identity/on_avr.cmake)
endif()
