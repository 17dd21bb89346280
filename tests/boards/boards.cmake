# Boards against this computer: what they print, and what they show.
set(SHADE16_BOARD_BUILDS ${PROJECT_SOURCE_DIR}/build CACHE PATH "Where the boards are built: one folder a board")

# The same app, the same words, on the board and here: the apps that a board gives its screen, with the program that has
# the same screen; the scenes, which have their own, wherever a board has the memory for them.
function(shade16_same_on_board board app host_program)
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  list(JOIN BOARD_EMULATOR " " emulator)
  shade16_add_script_test(same_on_board.${app}.${board} LABEL boards SCRIPT boards/same_on_board.cmake
    BOARD=${board} "EMULATOR=${emulator}" IMAGE=${SHADE16_BOARD_BUILDS}/${board}/firmware/${app}.elf
    HOST_PROGRAM=$<TARGET_FILE:${host_program}>)
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
shade16_add_script_test(board_table_is_fresh LABEL system SCRIPT budget/run_python.cmake
  PROGRAM=${PROJECT_SOURCE_DIR}/scripts/boards/table.py)
