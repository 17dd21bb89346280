# Every frame of every app against frames.txt: the board build runs its images, the host build its own programs.
get_property(apps GLOBAL PROPERTY SHADE16_APPS)

# Boards with the same screen and model draw the same frames: the first of them has them, and the others say BOARD_FRAMES_OF.
function(shade16_frames_of board result)
  set(BOARD_FRAMES_OF ${board})
  include(${SHADE16_BOARDS_DIR}/${board}/board.cmake)
  set(${result} ${BOARD_FRAMES_OF} PARENT_SCOPE)
endfunction()

if(BOARD)
  list(JOIN BOARD_EMULATOR " " emulator)
  shade16_frames_of(${BOARD} frames_of)
  foreach(app IN LISTS apps)
    if(emulator)
      shade16_add_script_test(golden.${app}.${BOARD} LABEL golden SCRIPT golden/check.cmake
        APP=${app} BOARD=${frames_of} "EMULATOR=${emulator}" PROGRAM=$<TARGET_FILE:${app}>)
    endif()
  endforeach()
  if(TARGET tables_in_ram)
    shade16_add_script_test(golden.tables_in_ram LABEL golden SCRIPT golden/check.cmake
      APP=turntable BOARD=${frames_of} "EMULATOR=${emulator}" PROGRAM=$<TARGET_FILE:tables_in_ram>)
  endif()
  return()
endif()

# The pictures behind the hashes, so that a changed frame can be looked at.
set(pictures_tool none)
if(TARGET host_sim_library)
  # Two files of the simulator's, and not all of it: who adds a board waits for this program.
  find_package(PNG REQUIRED)
  find_package(ZLIB REQUIRED)
  find_package(fmt REQUIRED)
  add_executable(golden_pictures ${CMAKE_CURRENT_SOURCE_DIR}/golden/pictures.cpp ${PROJECT_SOURCE_DIR}/host_sim/io/png_chunk.cpp
                                 ${PROJECT_SOURCE_DIR}/host_sim/io/atomic_file.cpp)
  target_include_directories(golden_pictures PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(golden_pictures PRIVATE PNG::PNG ZLIB::ZLIB fmt::fmt shade16_warnings)
  add_dependencies(checks golden_pictures)
  set(pictures_tool $<TARGET_FILE:golden_pictures>)
endif()
set(changed_pictures ${PROJECT_SOURCE_DIR}/out/bless)

get_property(boards GLOBAL PROPERTY SHADE16_EMULATED_BOARDS)
foreach(app IN LISTS apps)
  foreach(board IN LISTS boards)
    add_dependencies(checks ${app}_${board})
    shade16_frames_of(${board} frames_of)
    if(NOT frames_of STREQUAL board)
      continue()
    endif()
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
    list(APPEND bless_rows ${app} ${board} $<TARGET_FILE:${app}_${board}>)
    list(APPEND bless_programs ${app}_${board})
  endforeach()
endforeach()

# Accepts today's frames, and leaves the changed ones in out/bless/, before, after and their difference, for the review.
if(TARGET golden_pictures)
  list(APPEND bless_programs golden_pictures)
endif()
add_custom_target(bless_frames
  COMMAND ${CMAKE_COMMAND} -DTOOL=${pictures_tool} -DCHANGED=${changed_pictures}
          -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/golden/bless
          -P ${CMAKE_CURRENT_SOURCE_DIR}/golden/bless.cmake -- ${bless_rows}
  DEPENDS ${bless_programs}
  COMMENT "Rewriting tests/golden/frames.txt and tests/golden/frames/"
  VERBATIM)

# The same, and tests/identity/hashes.txt as well.
add_custom_target(bless)
add_dependencies(bless bless_frames)
