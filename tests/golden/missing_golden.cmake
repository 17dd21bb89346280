# A frame that nobody has blessed must fail, and so must one that is blessed but not drawn: in a copy of this folder.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/frames.cmake)
file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/../scripts DESTINATION ${SCRATCH})

function(expect_failure rows words)
  file(WRITE ${SCRATCH}/golden/frames.txt "${rows}")
  execute_process(COMMAND ${CMAKE_COMMAND} -DAPP=${APP} -DBOARD=${BOARD} -DPROGRAM=${PROGRAM}
                  -P ${SCRATCH}/golden/check.cmake RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE complaint)
  string(REGEX REPLACE "[ \n]+" " " complaint "${complaint}")
  if(status EQUAL 0 OR NOT complaint MATCHES "${words}")
    message(FATAL_ERROR "The check of golden frames was to fail with '${words}'. It ended with ${status}: ${complaint}")
  endif()
endfunction()

shade16_run(printed ${PROGRAM})
shade16_frames(${APP} ${BOARD} "${printed}" drawn)  # as if blessed just now
list(JOIN drawn "\n" golden)
expect_failure("" "is not in tests/golden/frames.txt")
expect_failure("${golden}\n${APP} ${BOARD} 99999 00000000\n" "but the app did not draw it")
string(REGEX REPLACE "(${APP} ${BOARD} 0) [0-9a-f]+" "\\1 00000000" changed "${golden}")
expect_failure("${changed}\n" "A frame has changed")
file(REMOVE_RECURSE ${SCRATCH})
