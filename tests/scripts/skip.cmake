# A test that needs something absent says so and is skipped, unless the environment asks for every test.
# Macros, so that return() leaves the script that uses them.
macro(shade16_skip reason)
  if("$ENV{SHADE16_REQUIRE_ALL}" STREQUAL "1")
    message(FATAL_ERROR "${reason} SHADE16_REQUIRE_ALL asks for every test, so this is a failure.")
  endif()
  message("SKIP: ${reason}")  # CTest looks for this word: see add_script_test.cmake
  return()
endmacro()

macro(shade16_skip_without_program name)
  find_program(program_${name} NAMES ${name})
  if(NOT program_${name})
    shade16_skip("${name} is not installed.")
  endif()
endmacro()

macro(shade16_skip_without_file path hint)
  if(NOT EXISTS ${path})
    shade16_skip("${path} does not exist: ${hint}")
  endif()
endmacro()

# shade16_skip_without_emulator(<program> [<argument>...]): a script of node's may need packages, too.
macro(shade16_skip_without_emulator program)
  shade16_skip_without_program(${program})
  foreach(word ${ARGN})
    if(word MATCHES "^qemu-system-")  # behind a program that waits for its end
      shade16_skip_without_program(${word})
    endif()
    if(word MATCHES "\\.mjs$")
      cmake_path(GET word PARENT_PATH folder)
      if(EXISTS ${folder}/package.json)
        shade16_skip_without_file(${folder}/node_modules "scripts/setup.sh installs it.")
      endif()
    endif()
  endforeach()
endmacro()
