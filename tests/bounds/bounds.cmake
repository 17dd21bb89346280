# Every bound that the engine promises is measured, every function has one, and the page says what was measured.
# One compiler: the page's last digits are those of its library's mathematics.
if(NOT TARGET shade16 OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()
set(measured ${CMAKE_CURRENT_BINARY_DIR}/bounds)

add_test(NAME bounds.are_kept COMMAND shade16 report bounds -o ${measured})
set_tests_properties(bounds.are_kept PROPERTIES TIMEOUT 600 LABELS bounds FIXTURES_SETUP bounds)

# shade16_add_bounds_test(<name> <python file> [<argument>...])
function(shade16_add_bounds_test name program)
  list(JOIN ARGN " " arguments)
  shade16_add_script_test(${name} LABEL bounds SCRIPT budget/run_python.cmake
    PROGRAM=${CMAKE_CURRENT_SOURCE_DIR}/bounds/${program} IMAGE= NEEDS=${NEEDS} RUN_TIMEOUT=900 "ARGUMENTS=${arguments}")
  set_tests_properties(${name} PROPERTIES TIMEOUT 900 FIXTURES_REQUIRED bounds)
endfunction()

set(include ${PROJECT_SOURCE_DIR}/core/include)
set(NEEDS clang++)  # for its syntax tree
shade16_add_bounds_test(bounds.every_function_has_one public_functions.py clang++ ${measured}/bounds.json ${include})
shade16_add_bounds_test(bounds.one_without_is_found public_functions.py clang++ ${measured}/bounds.json ${include}
  ${CMAKE_CURRENT_SOURCE_DIR}/bounds/unbounded)
set_tests_properties(bounds.one_without_is_found PROPERTIES
  PASS_REGULAR_EXPRESSION "ended with '1'.*num/unbounded.hpp: about_twice has no bound")
set(NEEDS g++)
shade16_add_bounds_test(bounds.page_is_fresh page_tables.py ${PROJECT_SOURCE_DIR}/docs/bounds.md ${measured}/bounds.md)
shade16_add_bounds_test(bounds.mutants_are_killed mutants.py g++ ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/mutants)
