# What a board's files must be, besides its image, and how its programs end.
get_property(apps GLOBAL PROPERTY SHADE16_APPS)
if(BOARD_UF2)
  foreach(app IN LISTS apps)
    shade16_add_script_test(uf2.${app} LABEL boards SCRIPT budget/run_python.cmake
      PROGRAM=${CMAKE_CURRENT_LIST_DIR}/check_uf2.py "ARGUMENTS=${PROJECT_BINARY_DIR}/firmware/${app}.bin ${PROJECT_BINARY_DIR}/firmware/${app}.uf2")
  endforeach()
endif()

# The board's own image, where an emulator has a part of what it needs: it must say what is missing.
if(BOARD_PANEL_STOPS)
  list(JOIN BOARD_PANEL_EMULATOR " " panel_emulator)
  shade16_add_script_test(panel_image_stops LABEL boards SCRIPT boards/stops.cmake
    "EMULATOR=${panel_emulator}" IMAGE=$<TARGET_FILE:turntable_panel> "SENTENCE=${BOARD_PANEL_STOPS}")
endif()

# A chip's flash makes the processor wait: the engine's tables can be among the variables, and draw the same frames.
if(BOARD_CHIP)
  shade16_add_image(tables_in_ram ${PROJECT_SOURCE_DIR}/firmware/apps/turntable.cpp)
  target_compile_definitions(tables_in_ram PRIVATE SHADE16_TABLES_IN_RAM)
  shade16_add_script_test(tables_in_ram.are_there LABEL boards SCRIPT boards/tables_in_ram.cmake NM=${CMAKE_NM} IMAGE=$<TARGET_FILE:tables_in_ram>
    PLAIN=$<TARGET_FILE:turntable>)
endif()

if(BOARD_EMULATOR)
  include(boards/faults/faults.cmake)
  list(GET BOARD_EMULATOR 0 emulator_program)
  shade16_add_script_test(stack.turntable LABEL budget SCRIPT budget/run_python.cmake PROGRAM=${PROJECT_SOURCE_DIR}/scripts/boards/stacks.py
    NEEDS=${emulator_program} "ARGUMENTS=${BOARD} ${PROJECT_BINARY_DIR}/firmware/turntable.elf")
endif()
