# What a board's files must be, besides its image.
if(BOARD_UF2)
  foreach(app IN LISTS apps)
    shade16_add_script_test(uf2.${app} LABEL boards SCRIPT budget/run_python.cmake
      PROGRAM=${CMAKE_CURRENT_LIST_DIR}/check_uf2.py "ARGUMENTS=${PROJECT_BINARY_DIR}/firmware/${app}.bin ${PROJECT_BINARY_DIR}/firmware/${app}.uf2")
  endforeach()
endif()
