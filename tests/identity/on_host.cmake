# This computer's two compilers, each without optimisation and with two kinds of it.
foreach(compiler IN ITEMS g++ clang++)
  set(name clang)
  if(compiler STREQUAL "g++")
    set(name gcc)
  endif()
  foreach(level IN ITEMS O0 O2 Os)
    set(machine ${name}-${level})
    set(program ${CMAKE_CURRENT_BINARY_DIR}/identity/${machine}/identity)
    shade16_identity_build(${machine} PROGRAM ${program} COMPILER ${compiler}
      SOURCES ${identity_all} tests/identity/main.cpp firmware/runtime/console.cpp firmware/runtime/console_host.cpp
      FLAGS -${level} -DSHADE16_QUICK_INPUTS=1000000 -DSHADE16_SLOW_INPUTS=1000000 -DSHADE16_LARGE_FRAMES
      LINK ${compiler} <objects> -o <program>)
    shade16_identity_test(${machine} PROGRAMS ${program} KINDS kernel frame large_frame LEAST 1000000 NEEDS ${compiler})
  endforeach()
endforeach()

# A check that cannot fail proves nothing.
shade16_add_script_test(identity.differences_are_found LABEL identity SCRIPT identity/self_test.cmake
  SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/identity/self_test)

# Accepts what this computer says today; the target 'bless' does it, too.
if(TARGET identity_gcc-O2)
  add_custom_target(bless_identity
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=${CMAKE_CURRENT_BINARY_DIR}/identity/gcc-O2/identity
            -P ${CMAKE_CURRENT_SOURCE_DIR}/identity/bless.cmake
    DEPENDS identity_gcc-O2
    COMMENT "Rewriting tests/identity/hashes.txt"
    VERBATIM)
  add_dependencies(bless bless_identity)
endif()
