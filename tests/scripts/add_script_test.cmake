# shade16_add_script_test(<name> LABEL <label> SCRIPT <file> [<variable>=<value>...]): a test written as a CMake script.
# A value cannot be a list; a command line is passed as one string and split by the script.
function(shade16_add_script_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL;SCRIPT" "")
  list(TRANSFORM arg_UNPARSED_ARGUMENTS PREPEND "-D" OUTPUT_VARIABLE definitions)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} ${definitions} -P ${CMAKE_CURRENT_SOURCE_DIR}/${arg_SCRIPT})
  set_tests_properties(${name} PROPERTIES TIMEOUT 120 LABELS "${arg_LABEL}" SKIP_REGULAR_EXPRESSION "SKIP: ")
endfunction()
