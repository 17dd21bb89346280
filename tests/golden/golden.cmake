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

# The pictures behind the hashes, so that a changed frame can be looked at.
set(pictures_tool none)
if(TARGET host_sim_library)
  find_package(PNG REQUIRED)
  add_executable(golden_pictures ${CMAKE_CURRENT_SOURCE_DIR}/golden/pictures.cpp)
  target_link_libraries(golden_pictures PRIVATE host_sim_library PNG::PNG shade16_warnings)
  add_dependencies(checks golden_pictures)
  set(pictures_tool $<TARGET_FILE:golden_pictures>)
endif()
set(changed_pictures ${PROJECT_SOURCE_DIR}/out/bless)

get_property(boards GLOBAL PROPERTY SHADE16_EMULATED_BOARDS)
foreach(app IN LISTS apps)
  foreach(board IN LISTS boards)
    set(scratch ${CMAKE_CURRENT_BINARY_DIR}/golden/${app}_${board})
    shade16_add_script_test(golden.${app}.${board} LABEL golden SCRIPT golden/check.cmake
      APP=${app} BOARD=${board} PROGRAM=$<TARGET_FILE:${app}_${board}>)
    if(TARGET golden_pictures)
      shade16_add_script_test(golden_pictures.${app}.${board} LABEL golden SCRIPT golden/check_pictures.cmake
        APP=${app} BOARD=${board} PROGRAM=$<TARGET_FILE:${app}_${board}> TOOL=${pictures_tool} SCRATCH=${scratch}
        CHANGED=${changed_pictures})
    endif()
    shade16_add_script_test(missing_golden_fails.${app}.${board} LABEL golden SCRIPT golden/missing_golden.cmake
      APP=${app} BOARD=${board} PROGRAM=$<TARGET_FILE:${app}_${board}> SCRATCH=${scratch}_missing)
    add_dependencies(checks ${app}_${board})
    list(APPEND bless_rows ${app} ${board} $<TARGET_FILE:${app}_${board}>)
  endforeach()
endforeach()

# Accepts today's frames, and leaves the changed ones in out/bless/, before, after and their difference, for the review.
add_custom_target(bless
  COMMAND ${CMAKE_COMMAND} -DTOOL=${pictures_tool} -DCHANGED=${changed_pictures}
          -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/golden/bless
          -P ${CMAKE_CURRENT_SOURCE_DIR}/golden/bless.cmake -- ${bless_rows}
  DEPENDS checks
  COMMENT "Rewriting tests/golden/frames.txt and tests/golden/frames/"
  VERBATIM)
