# A check that cannot fail proves nothing: a file without a header, a header without its file and a stale one are each
# named by baked_assets.cmake.
cmake_minimum_required(VERSION 3.25)

# shade16_expect_refusal(<folder> <sentence>): of what lies in that folder of SCRATCH.
function(shade16_expect_refusal folder sentence)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${SCRATCH} -DFOLDER=${folder} -DENDING=toml -DALL=ON -DPROGRAM=${PROGRAM}
            -DSCRATCH=${SCRATCH}/baked -P ${CMAKE_CURRENT_LIST_DIR}/baked_assets.cmake
    RESULT_VARIABLE status ERROR_VARIABLE complaint OUTPUT_QUIET)
  string(REGEX REPLACE "[ \n]+" " " complaint "${complaint}")  # CMake breaks lines where it likes
  string(FIND "${complaint}" "${sentence}" at)
  if(status EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "baked_assets.cmake ended with ${status} and did not say '${sentence}':\n${complaint}")
  endif()
endfunction()

set(scene "[meshes.m]\nshape = \"cube\"\n[[objects]]\nmesh = \"m\"\n")
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH}/empty)
file(WRITE ${SCRATCH}/lonely/scene.toml "${scene}")
file(WRITE ${SCRATCH}/lonely/orphan.hpp "")
file(WRITE ${SCRATCH}/stale/scene.toml "${scene}")
file(WRITE ${SCRATCH}/stale/scene.hpp "// by hand\n")

shade16_expect_refusal(empty "There is no baked header under empty/")
shade16_expect_refusal(lonely "lonely/scene.hpp is missing: run 'shade16 bake lonely/scene.toml -o lonely/scene.hpp'.")
shade16_expect_refusal(lonely "lonely/orphan.hpp was baked of lonely/orphan.toml, which is not there.")
shade16_expect_refusal(stale "stale/scene.hpp is stale: run 'shade16 bake stale/scene.toml -o stale/scene.hpp'.")
