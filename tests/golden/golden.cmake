# Every frame of every app against frames.txt: the board build runs its images, the host build its own programs.
get_property(apps GLOBAL PROPERTY SHADE16_APPS)

if(BOARD)
  list(JOIN BOARD_EMULATOR " " emulator)
  foreach(app IN LISTS apps)
    if(emulator)
      shade16_add_script_test(golden.${app}.${BOARD} LABEL golden SCRIPT golden/check.cmake
        APP=${app} BOARD=${BOARD} "EMULATOR=${emulator}" PROGRAM=$<TARGET_FILE:${app}>)
    endif()
  endforeach()
  return()
endif()

get_property(boards GLOBAL PROPERTY SHADE16_EMULATED_BOARDS)
foreach(app IN LISTS apps)
  foreach(board IN LISTS boards)
    shade16_add_script_test(golden.${app}.${board} LABEL golden SCRIPT golden/check.cmake
      APP=${app} BOARD=${board} PROGRAM=$<TARGET_FILE:${app}_${board}>)
    add_dependencies(checks ${app}_${board})
    list(APPEND bless_rows ${app} ${board} $<TARGET_FILE:${app}_${board}>)
  endforeach()
endforeach()

# Accepts today's frames. Look at the pictures first: the difference goes into the review.
add_custom_target(bless
  COMMAND ${CMAKE_COMMAND} -P ${CMAKE_CURRENT_SOURCE_DIR}/golden/bless.cmake -- ${bless_rows}
  DEPENDS checks
  COMMENT "Rewriting tests/golden/frames.txt"
  VERBATIM)
