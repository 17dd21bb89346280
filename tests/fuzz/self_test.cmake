# A fuzzer with a planted mistake: the run must fail, and keep the bytes that showed it.
execute_process(COMMAND ${CMAKE_COMMAND} -DFUZZER=${FUZZER} -DSCRATCH=${SCRATCH} -DSECONDS=60 -P ${CMAKE_CURRENT_LIST_DIR}/run.cmake
  ERROR_VARIABLE printed OUTPUT_QUIET RESULT_VARIABLE status)
if(status EQUAL 0)
  message(FATAL_ERROR "${FUZZER} has a mistake, and nobody found it.")
endif()
file(GLOB found ${SCRATCH}/found/crash-*)
if(found STREQUAL "" OR NOT printed MATCHES "found/crash-")
  message(FATAL_ERROR "The mistake was found, but its bytes were not kept or not named:\n${printed}")
endif()
