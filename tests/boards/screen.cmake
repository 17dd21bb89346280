# The picture on an emulated board's display, against the one that the same app draws on this computer: see screen_dump.py.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)

include(${CMAKE_CURRENT_LIST_DIR}/../../boards/${BOARD}/board.cmake)
shade16_skip_without_emulator(${BOARD_EMULATOR})
shade16_skip_without_program(python3)
shade16_skip_without_file(${IMAGE} "build it with 'cmake --workflow --preset ${BOARD}'.")

set(picture "")
if(KEPT)
  set(picture --kept ${KEPT})
elseif(KEEP)
  set(picture --keep ${KEEP})
endif()
set(model "")
if(BOARD_SCREEN_MODEL)
  set(model --model ${DECODER} ${BOARD_SCREEN_MODEL})
endif()
execute_process(
  COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/screen_dump.py --bits ${BOARD_SCREEN_BITS} --program ${HOST_PROGRAM} --image ${IMAGE}
          ${picture} ${model} -- ${BOARD_EMULATOR}
  RESULT_VARIABLE status OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${BOARD}: ${printed}")
endif()
message("${printed}")
