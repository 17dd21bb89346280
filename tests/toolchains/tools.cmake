# shade16_tool_names(<programs> <packages>): the two halves of each "program=package" of TOOLS.
function(shade16_tool_names programs packages)
  separate_arguments(tools UNIX_COMMAND "${TOOLS}")
  list(TRANSFORM tools REPLACE "=.*" "" OUTPUT_VARIABLE first)
  list(TRANSFORM tools REPLACE ".*=" "" OUTPUT_VARIABLE second)
  set(${programs} ${first} PARENT_SCOPE)
  set(${packages} ${second} PARENT_SCOPE)
endfunction()
