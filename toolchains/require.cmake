# shade16_require(<variable> <Debian package> <program>...): where the first of the programs is, as each may have several names; or one
# sentence that says what is missing. What counts is the PATH, as for whoever types the program's name.
function(shade16_require variable package)
  list(GET ARGN 0 first)
  find_program(SHADE16_${first} NAMES ${ARGN} NO_CMAKE_SYSTEM_PATH)
  if(NOT SHADE16_${first})
    list(JOIN ARGN " or " names)
    message(FATAL_ERROR "There is no ${names}; Debian has it in ${package}.")
  endif()
  mark_as_advanced(SHADE16_${first})
  set(${variable} ${SHADE16_${first}} PARENT_SCOPE)
endfunction()
