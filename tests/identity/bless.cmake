# Rewrites hashes.txt from what PROGRAM says.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../scripts/run.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/rows.cmake)

shade16_run(printed ${PROGRAM})
shade16_identity_rows("${printed}" rows)
list(JOIN rows "\n" lines)
file(WRITE ${CMAKE_CURRENT_LIST_DIR}/hashes.txt
  "# kernel <name> <inputs> <hash>, and (large_)frame <name> <hash>. Written by 'bless_identity'; equal on every machine.\n${lines}\n")
