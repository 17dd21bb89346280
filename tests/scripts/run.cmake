# shade16_run(<output> <program> [<argument>...]): what the program prints; any status but 0 fails the test.
function(shade16_run output)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE printed ERROR_VARIABLE complaint RESULT_VARIABLE status TIMEOUT 60)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "This command ended with '${status}':\n  ${command}\nIt printed:\n${printed}${complaint}")
  endif()
  set(${output} "${printed}" PARENT_SCOPE)
endfunction()
