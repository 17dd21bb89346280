# An AVR, whose int has 16 bits: the kernels, a group an image. avr-gcc knows no C++20; it links what clang compiles, with its
# library. -Oz because clang 14 fails on GLSL's functions with -Os, and its code of -O2 crashes while it builds a shininess table.
# In simavr it is a thousand times slower than this computer, so it gets a thousand arguments a kernel, or ten thousand on request.
set(inputs 1000)
if(SHADE16_IDENTITY_ALL)
  set(inputs 10000)
endif()
set(programs)
foreach(group IN ITEMS number vector glsl)
  set(program ${CMAKE_CURRENT_BINARY_DIR}/identity/avr_${group}/identity.elf)
  shade16_identity_build(avr_${group} PROGRAM ${program} COMPILER clang++ TOOLCHAIN clang-avr
    SOURCES tests/identity/${group}_kernels.cpp tests/identity/main_avr.cpp firmware/runtime/console.cpp firmware/runtime/memory_functions.cpp
    FLAGS -mmcu=atmega1284p -Oz -DSHADE16_KERNELS=say_${group}_kernels -DSHADE16_INPUTS=${inputs}
    LINK avr-gcc -mmcu=atmega1284p -nostdlib -Wl,--gc-sections <objects> -lgcc -o <program>)
  list(APPEND programs ${program})
endforeach()
shade16_identity_test(avr PROGRAMS ${programs} KINDS kernel LEAST ${inputs} NEEDS clang++ avr-gcc simavr
  EMULATOR simavr -m atmega1284p -f 16000000)
