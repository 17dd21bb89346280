# On the host, with the boards built beside: the instructions of each benchmark scene against budgets.csv.
add_library(instruction_counter MODULE ${CMAKE_CURRENT_SOURCE_DIR}/budget/counter/instruction_counter.cpp)
target_link_libraries(instruction_counter PRIVATE shade16_warnings)
# QEMU loads it, and QEMU is not sanitized.
target_compile_options(instruction_counter PRIVATE -fvisibility=hidden -fno-sanitize=all)
target_link_options(instruction_counter PRIVATE -fno-sanitize=all)

# shade16_add_bench_test(<name> <python file> <image it needs first, or ""> [<argument>...])
function(shade16_add_bench_test name program image)
  list(JOIN ARGN " " arguments)
  shade16_add_script_test(${name} LABEL budget SCRIPT budget/run_python.cmake
    PROGRAM=${program} IMAGE=${image} "ARGUMENTS=${arguments}")
endfunction()

shade16_add_bench_test(bench.logic ${CMAKE_CURRENT_SOURCE_DIR}/budget/bench_test.py "")

foreach(board IN LISTS SHADE16_BOARDS)
  unset(BOARD_SCENES)
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  if(NOT BOARD_SCENES)
    continue()
  endif()
  set(known_count ${SHADE16_BOARD_BUILDS}/${board}/tests/known_count.elf)
  shade16_add_bench_test(bench.counts_exactly.${board} ${CMAKE_CURRENT_SOURCE_DIR}/budget/known_count_test.py
    ${known_count} ${known_count} ${board} $<TARGET_FILE:instruction_counter>)
  shade16_add_bench_test(bench.budgets.${board} ${PROJECT_SOURCE_DIR}/scripts/bench/check_budgets.py
    ${SHADE16_BOARD_BUILDS}/${board}/firmware/scene_s1.elf
    ${board} ${SHADE16_BOARD_BUILDS} $<TARGET_FILE:instruction_counter>)
  if(TARGET shade16 AND board STREQUAL "qemu_mps2_an385")  # what is linked is the compiler's choice alike on all
    shade16_add_bench_test(terms.link_nothing_else.${board} ${CMAKE_CURRENT_SOURCE_DIR}/budget/term_code_test.py
      ${SHADE16_BOARD_BUILDS}/${board}/firmware/scene_s1.elf ${SHADE16_BOARD_BUILDS}/${board}/firmware $<TARGET_FILE:shade16>)
  endif()
endforeach()
