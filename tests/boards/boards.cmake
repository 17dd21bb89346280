# Boards against this computer: what they print, and what they show.
set(SHADE16_BOARD_BUILDS ${PROJECT_SOURCE_DIR}/build CACHE PATH "Where the boards are built: one folder a board")

# Builds this computer's side of the comparisons.
add_custom_target(board_checks)

# The same app, the same words, on the board and here: the apps that a board gives its screen, with the program that has
# the same screen; the scenes, which have their own, wherever a board has the memory for them.
function(shade16_same_on_board board app host_program)
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  if(app MATCHES "_panel$")
    set(BOARD_EMULATOR python3 -B ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/until_exit.py ${BOARD_PANEL_EMULATOR})
  endif()
  list(JOIN BOARD_EMULATOR " " emulator)
  add_dependencies(board_checks ${host_program})
  shade16_add_script_test(same_on_board.${app}.${board} LABEL boards SCRIPT boards/same_on_board.cmake
    BOARD=${board} "EMULATOR=${emulator}" IMAGE=${SHADE16_BOARD_BUILDS}/${board}/firmware/${app}.elf
    HOST_PROGRAM=$<TARGET_FILE:${host_program}>)
endfunction()

# Whether an emulator takes the board's own image, with its clocks, its panel's driver and its serial line.
function(shade16_runs_panel_image board result)
  set(BOARD_PANEL_EMULATOR)
  set(BOARD_PANEL_STOPS)
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  set(${result} FALSE PARENT_SCOPE)
  if(BOARD_PANEL_EMULATOR AND NOT BOARD_PANEL_STOPS)
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()

function(shade16_has_scenes board result)
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  set(${result} ${BOARD_SCENES} PARENT_SCOPE)
endfunction()

# Where an emulator shows the panel: the picture that an app leaves on it.
function(shade16_screen_test board host_program)
  set(BOARD_SCREEN_BITS)
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  if(BOARD_SCREEN_BITS)
    add_dependencies(board_checks decode_display)
    shade16_add_script_test(screen_shows_the_frame.${board} LABEL boards SCRIPT boards/screen.cmake BOARD=${board}
      IMAGE=${SHADE16_BOARD_BUILDS}/${board}/firmware/turntable.elf HOST_PROGRAM=$<TARGET_FILE:${host_program}>
      KEPT=${PROJECT_SOURCE_DIR}/docs/img/boards/${board}.png DECODER=$<TARGET_FILE:decode_display>)
  endif()
endfunction()

get_property(apps GLOBAL PROPERTY SHADE16_APPS)
get_property(scenes GLOBAL PROPERTY SHADE16_SCENES)
get_property(boards GLOBAL PROPERTY SHADE16_EMULATED_BOARDS)
foreach(board IN LISTS boards)
  foreach(app IN LISTS apps)
    shade16_same_on_board(${board} ${app} ${app}_${board})
  endforeach()
  shade16_screen_test(${board} turntable_${board})
  shade16_runs_panel_image(${board} runs_panel_image)
  if(runs_panel_image)
    shade16_same_on_board(${board} turntable_panel turntable_${board})
  endif()
  shade16_has_scenes(${board} has_scenes)
  if(has_scenes)
    foreach(scene IN LISTS scenes)
      shade16_same_on_board(${board} scene_${scene} scene_${scene})
    endforeach()
  endif()
endforeach()

# A comparison that finds nothing proves nothing.
shade16_add_script_test(wrong_screens_are_found LABEL boards SCRIPT budget/run_python.cmake
  PROGRAM=${CMAKE_CURRENT_LIST_DIR}/screen_dump_self_test.py)

shade16_add_script_test(large_stacks_are_found LABEL boards SCRIPT budget/run_python.cmake
  PROGRAM=${CMAKE_CURRENT_SOURCE_DIR}/budget/stacks_test.py)

# A folder is a board: its presets are made of it.
shade16_add_script_test(board_presets_are_fresh LABEL system SCRIPT budget/run_python.cmake
  PROGRAM=${PROJECT_SOURCE_DIR}/scripts/boards/presets.py)
shade16_add_script_test(bus_table_is_fresh LABEL system SCRIPT budget/run_python.cmake
  PROGRAM=${PROJECT_SOURCE_DIR}/scripts/boards/bus.py)
shade16_add_script_test(board_table_is_fresh LABEL system SCRIPT budget/run_python.cmake
  PROGRAM=${PROJECT_SOURCE_DIR}/scripts/boards/table.py)

# A text is a panel: the drivers' headers are made of it.
shade16_add_script_test(panel_headers_are_fresh LABEL system SCRIPT budget/run_python.cmake
  PROGRAM=${PROJECT_SOURCE_DIR}/scripts/boards/panels.py)
shade16_add_script_test(panel_headers.texts_become_headers LABEL system SCRIPT budget/run_python.cmake
  PROGRAM=${CMAKE_CURRENT_LIST_DIR}/panels_self_test.py)
