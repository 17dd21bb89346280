# What images must not contain, what a frame takes, and images that scripts/bench.sh measures.

# What a frame of the turntable takes, by stage.
if(BOARD_EMULATOR)
  list(JOIN BOARD_EMULATOR " " emulator)
  shade16_add_script_test(bench LABEL budget SCRIPT budget/run_python.cmake PROGRAM=${PROJECT_SOURCE_DIR}/scripts/boards/bench.py
    "ARGUMENTS=${BOARD} $<TARGET_FILE:bench> ${emulator}")
endif()

# A check that cannot fail proves nothing (the check itself: every_image.cmake). This image breaks the rules, and every broken rule must be named.
shade16_add_image(rule_breaker ${CMAKE_CURRENT_SOURCE_DIR}/budget/rule_breaker.cpp)
shade16_add_script_test(forbidden_symbols.are_found LABEL budget SCRIPT budget/forbidden_symbols_self_test.cmake
  NM=${CMAKE_NM} IMAGE=$<TARGET_FILE:rule_breaker>)

# What the instruction counter is tested with, from the host build: see instructions.cmake. It counts on Cortex-M, what GCC makes.
if(BOARD_STARTUP STREQUAL "cortex_m" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  shade16_add_image(known_count ${CMAKE_CURRENT_SOURCE_DIR}/budget/counter/known_count.cpp)
endif()

# What scripts/bench.sh --glsl counts in, built when it asks.
shade16_add_image(glsl_cost ${CMAKE_CURRENT_SOURCE_DIR}/budget/glsl_cost.cpp)
set_target_properties(glsl_cost PROPERTIES EXCLUDE_FROM_ALL ON)

# What scripts/bench.sh --terms measures: a scene with one term more, an image each, built when it asks. The names and terms are those of
# scripts/bench/term_costs.py.
file(STRINGS ${PROJECT_SOURCE_DIR}/scripts/bench/term_costs.py lines REGEX "^    \"[a-z_]+\": \\(\"")
foreach(line IN LISTS lines)
  string(REGEX MATCHALL "\"[a-z_]+\": \\(\"[a-z_ ]*\"" variants "${line}")
  foreach(variant IN LISTS variants)
    string(REGEX REPLACE "^\"([a-z_]+)\": \\(\"([a-z_ ]*)\"$" "\\1" name "${variant}")
    string(REGEX REPLACE "^\"([a-z_]+)\": \\(\"([a-z_ ]*)\"$" "\\2" terms "${variant}")
    shade16_add_image(term_${name} ${CMAKE_CURRENT_SOURCE_DIR}/budget/term_scene.cpp)
    target_compile_definitions(term_${name} PRIVATE "SHADE16_TERMS=\" ${terms}\"")
    set_target_properties(term_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  endforeach()
endforeach()
