# shade16_run(<output> <program> [<argument>...]): what the program prints; any status but 0 fails the test. It has a minute,
# or RUN_TIMEOUT seconds.
function(shade16_run output)
  if(NOT RUN_TIMEOUT)
    set(RUN_TIMEOUT 60)
  endif()
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE printed ERROR_VARIABLE complaint RESULT_VARIABLE status TIMEOUT ${RUN_TIMEOUT})
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "This command ended with '${status}':\n  ${command}\nIt printed:\n${printed}${complaint}")
  endif()
  set(${output} "${printed}" PARENT_SCOPE)
endfunction()
