# What a board's files must be, besides its image, and how its programs end.
get_property(apps GLOBAL PROPERTY SHADE16_APPS)
if(BOARD_UF2)
  foreach(app IN LISTS apps)
    shade16_add_script_test(uf2.${app} LABEL boards SCRIPT budget/run_python.cmake
      PROGRAM=${CMAKE_CURRENT_LIST_DIR}/check_uf2.py "ARGUMENTS=${PROJECT_BINARY_DIR}/firmware/${app}.bin ${PROJECT_BINARY_DIR}/firmware/${app}.uf2")
  endforeach()
endif()

if(BOARD_EMULATOR)
  include(boards/faults/faults.cmake)
  list(GET BOARD_EMULATOR 0 emulator_program)
  shade16_add_script_test(stack.turntable LABEL budget SCRIPT budget/run_python.cmake PROGRAM=${PROJECT_SOURCE_DIR}/scripts/boards/stacks.py
    NEEDS=${emulator_program} "ARGUMENTS=${BOARD} ${PROJECT_BINARY_DIR}/firmware/turntable.elf")
endif()
