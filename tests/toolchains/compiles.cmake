# A project with nothing but TOOLCHAIN compiles the engine.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/skip.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/tools.cmake)

shade16_tool_names(programs packages)
foreach(program IN LISTS programs)
  shade16_skip_without_program(${program})
endforeach()
file(REMOVE_RECURSE ${SCRATCH})
shade16_run(ignored ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${SCRATCH} -G Ninja -DCMAKE_MAKE_PROGRAM=${NINJA}
  -DCMAKE_TOOLCHAIN_FILE=${TOOLCHAIN} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DSOURCE=${SOURCE})
shade16_run(ignored ${CMAKE_COMMAND} --build ${SCRATCH})
