# The check itself, in a copy of this folder: with the machine that prints hashes.txt, and four that do not.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/../scripts DESTINATION ${SCRATCH})
set(hashes ${SCRATCH}/identity/hashes.txt)
set(machine ${SCRATCH}/machine.txt)
file(READ ${hashes} golden)
file(WRITE ${machine} "${golden}")

function(check words)
  execute_process(COMMAND ${CMAKE_COMMAND} -DMACHINE=parrot "-DEMULATOR=${CMAKE_COMMAND} -E cat" -DPROGRAMS=${machine}
                  "-DKINDS=kernel frame large_frame" -DLEAST=1000000 -P ${SCRATCH}/identity/check.cmake
                  RESULT_VARIABLE status ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  if((words STREQUAL "" AND NOT status EQUAL 0) OR (NOT words STREQUAL "" AND (status EQUAL 0 OR NOT said MATCHES "${words}")))
    message(FATAL_ERROR "The check was to end with '${words}'. It ended with ${status}: ${said}")
  endif()
endfunction()

check("")

string(REGEX MATCH "kernel number.rsqrt_newton 10000 ([0-9a-f]+)" row "${golden}")
set(right ${CMAKE_MATCH_1})
string(REPLACE "${row}" "kernel number.rsqrt_newton 10000 00000000" changed "${golden}")
file(WRITE ${hashes} "${changed}")
check("kernel number.rsqrt_newton on parrot, within the first 10000 inputs: expected 00000000, found ${right}\\.")

string(REGEX REPLACE "(\nframe [^ ]+) [0-9a-f]+" "\\1 00000000" changed "${golden}")
file(WRITE ${hashes} "${changed}")
check("frame [^ ]+ on parrot: expected 00000000, found")

string(REPLACE "${row}\n" "" changed "${golden}")
file(WRITE ${hashes} "${changed}")
check("'${row}' of parrot is not in tests/identity/hashes.txt")

file(WRITE ${hashes} "${golden}")
file(WRITE ${machine} "${changed}")
check("'kernel number.rsqrt_newton 10000' is in tests/identity/hashes.txt, but parrot did not print it")
file(REMOVE_RECURSE ${SCRATCH})
