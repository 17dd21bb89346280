# shade16_pictures(<action> <tool> <app> <board> <program> <scratch> <changed> <status>): draws every frame to <scratch>,
# and checks or blesses tests/golden/frames/<app>_<board>_<frame>.png.
function(shade16_pictures action tool app board program scratch changed status)
  file(REMOVE_RECURSE ${scratch})
  file(MAKE_DIRECTORY ${scratch})
  shade16_run(ignored ${CMAKE_COMMAND} -E env SHADE16_FRAMES=${scratch} ${program})
  execute_process(COMMAND ${tool} ${action} ${scratch} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/frames/${app}_${board}
                  ${changed}/${app}_${board} RESULT_VARIABLE result)
  file(REMOVE_RECURSE ${scratch})
  set(${status} "${result}" PARENT_SCOPE)
endfunction()
