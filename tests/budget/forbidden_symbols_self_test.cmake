# Runs the check on an image that breaks the rules, and expects to hear about each.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${CMAKE_COMMAND} -DNM=${NM} -DIMAGE=${IMAGE}
                        -P ${CMAKE_CURRENT_LIST_DIR}/forbidden_symbols.cmake
                ERROR_VARIABLE complaint RESULT_VARIABLE status)
if(status EQUAL 0)
  message(FATAL_ERROR "The check accepted an image that uses floating point.")
endif()
string(REGEX REPLACE "[ \n]+" " " complaint "${complaint}")  # CMake wraps long lines
foreach(phrase IN ITEMS "floating point: .*(__aeabi_fadd|__addsf3)" "division of 64 bits: .*(ldivmod|__divdi3)" "heap: malloc"
                        "language support: .*atexit")
  if(NOT complaint MATCHES "${phrase}")
    message(FATAL_ERROR "The check did not report '${phrase}'. It said: ${complaint}")
  endif()
endforeach()
