# docs/extremes.md: every trap has a promise and a test that exists. And that the check can fail.
shade16_add_script_test(extremes.table LABEL extremes SCRIPT budget/run_python.cmake
  PROGRAM=${CMAKE_CURRENT_SOURCE_DIR}/extremes/check_table.py "ARGUMENTS=${PROJECT_SOURCE_DIR}")
shade16_add_script_test(extremes.table_check_can_fail LABEL extremes SCRIPT budget/run_python.cmake
  PROGRAM=${CMAKE_CURRENT_SOURCE_DIR}/extremes/check_table_test.py)
