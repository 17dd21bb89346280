# With nothing in the PATH, and then with one tool more at a time, TOOLCHAIN says in one sentence which is missing and who brings it.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/tools.cmake)

shade16_tool_names(programs packages)
set(path ${SCRATCH}/path)
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${path})
foreach(program package IN ZIP_LISTS programs packages)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env PATH=${path} ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${SCRATCH}/build -G Ninja
            -DCMAKE_MAKE_PROGRAM=${NINJA} -DCMAKE_TOOLCHAIN_FILE=${TOOLCHAIN}
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  string(REGEX MATCHALL "CMake Error at" errors "${said}")
  list(LENGTH errors count)
  string(REGEX REPLACE "[ \n]+" " " words "${said}")
  string(REPLACE "+" "\\+" name ${program})
  if(status EQUAL 0 OR NOT count EQUAL 1 OR NOT words MATCHES "\\(message\\): There is no ${name}[^.]*; Debian has it in ${package}\\.")
    message(FATAL_ERROR "Without ${program} one sentence was expected that names it and ${package}. CMake ended with ${status}:\n${said}")
  endif()
  # Now it is there, as far as anybody can see: nobody gets as far as running it.
  file(WRITE ${path}/${program} "")
  file(CHMOD ${path}/${program} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  file(REMOVE_RECURSE ${SCRATCH}/build)
endforeach()
