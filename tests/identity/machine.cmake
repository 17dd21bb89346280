# shade16_identity_build(<machine> PROGRAM <file> COMPILER <program> [TOOLCHAIN <file of toolchains/>] SOURCES <file>... [FLAGS <flag>...]
# LINK <command>...): the program of a machine that CMake's own compiler does not make. LINK has <objects> and <program> where they belong.
# Without its compiler and linker nothing is built, and the test says what is missing.
function(shade16_identity_build machine)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PROGRAM;COMPILER;TOOLCHAIN" "SOURCES;FLAGS;LINK")
  list(POP_FRONT arg_LINK linker)
  find_program(SHADE16_${arg_COMPILER} NAMES ${arg_COMPILER})
  find_program(SHADE16_${linker} NAMES ${linker})
  if(NOT SHADE16_${arg_COMPILER} OR NOT SHADE16_${linker})
    return()
  endif()
  if(arg_TOOLCHAIN)  # for this function alone
    include(${PROJECT_SOURCE_DIR}/toolchains/${arg_TOOLCHAIN}.cmake)
    list(PREPEND arg_FLAGS --target=${CMAKE_CXX_COMPILER_TARGET} ${SHADE16_FREESTANDING} ${SHADE16_FREESTANDING_CXX})
  endif()

  get_target_property(warnings shade16_warnings INTERFACE_COMPILE_OPTIONS)
  set(objects)
  foreach(source IN LISTS arg_SOURCES)
    cmake_path(GET source STEM stem)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/identity/${machine}/${stem}.o)
    set(flags ${arg_FLAGS})
    if(stem STREQUAL "memory_functions")
      list(APPEND flags -fno-builtin)
    endif()
    add_custom_command(OUTPUT ${object}
      COMMAND ${SHADE16_${arg_COMPILER}} -std=c++20 ${warnings} ${flags} -I${PROJECT_SOURCE_DIR} -I${PROJECT_SOURCE_DIR}/firmware
              -I${PROJECT_SOURCE_DIR}/core/include -MD -MF ${object}.d -c ${PROJECT_SOURCE_DIR}/${source} -o ${object}
      DEPENDS ${PROJECT_SOURCE_DIR}/${source} DEPFILE ${object}.d COMMENT "Building ${stem} for ${machine}" VERBATIM)
    list(APPEND objects ${object})
  endforeach()

  set(command ${SHADE16_${linker}})
  foreach(word IN LISTS arg_LINK)
    if(word STREQUAL "<objects>")
      list(APPEND command ${objects})
    elseif(word STREQUAL "<program>")
      list(APPEND command ${arg_PROGRAM})
    else()
      list(APPEND command ${word})
    endif()
  endforeach()
  add_custom_command(OUTPUT ${arg_PROGRAM} COMMAND ${command} DEPENDS ${objects} COMMENT "Linking ${machine}" VERBATIM)
  add_custom_target(identity_${machine} ALL DEPENDS ${arg_PROGRAM})
  add_dependencies(checks identity_${machine})
endfunction()
