# No `float` and no `double` in the core's code, not even at compile time: a double has 32 bits on AVR.
cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE headers RELATIVE ${SOURCE} ${SOURCE}/core/include/*)
if(NOT headers)
  message(FATAL_ERROR "There is no header under core/include: this test would pass without looking at anything.")
endif()

# Comments and string literals may use the words.
function(shade16_code_only text result)
  string(REGEX REPLACE "\"([^\"\\\n]|\\\\.)*\"" "\"\"" text "${text}")
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "/\\*([^*]|\\*+[^*/])*\\*+/" "" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

function(shade16_floating_word text result)
  shade16_code_only("${text}" code)
  string(REGEX MATCH "(^|[^A-Za-z0-9_])(float|double)([^A-Za-z0-9_]|$)" found " ${code} ")
  set(${result} "${CMAKE_MATCH_2}" PARENT_SCOPE)
endfunction()

# The check itself first: it must see the word in code and only there.
shade16_floating_word("// float\n/* double * */ const char* s = \"a \\\" float\"; int floaty;" found)
if(found)
  message(FATAL_ERROR "This test takes a comment, a string or a longer name for '${found}'.")
endif()
shade16_floating_word("int a; /* x */ (float)a; // y" found)
if(NOT found STREQUAL "float")
  message(FATAL_ERROR "This test does not see 'float' in code.")
endif()

foreach(header IN LISTS headers)
  file(READ ${SOURCE}/${header} text)
  shade16_floating_word("${text}" found)
  if(found)
    message(SEND_ERROR "${header} uses '${found}'.")
  endif()
endforeach()
