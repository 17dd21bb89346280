# A board that is asked for with another processor's toolchain, or with none that exists.
cmake_minimum_required(VERSION 3.25)
foreach(toolchain IN ITEMS clang-riscv32 clang-thum)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/../.. -B ${SCRATCH} -G Ninja -DCMAKE_MAKE_PROGRAM=${NINJA} -DBOARD=qemu_microbit
            -DTOOLCHAIN=${toolchain}
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  set(expected "TOOLCHAIN=${toolchain} does not make code for 'qemu_microbit'; what does: arm-none-eabi, clang-thumb\\.")
  if(status EQUAL 0 OR NOT said MATCHES "${expected}")
    message(FATAL_ERROR "Expected '${expected}'. CMake ended with ${status}: ${said}")
  endif()
endforeach()
