# Each mistake in a board's folder stops the configuration with its own sentence.
cmake_minimum_required(VERSION 3.25)

set(right "include(${SOURCE}/boards/qemu_mps2_an385/board.cmake)\n")
set(folder ${WORK}/boards/mine)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${folder})
file(TOUCH ${folder}/board.hpp ${folder}/memory.ld)
file(WRITE ${WORK}/check.cmake "cmake_minimum_required(VERSION 3.25)\ninclude(${folder}/board.cmake)\ninclude(${SOURCE}/toolchains/check_board.cmake)\nshade16_check_board()\n")

# check(<board.cmake> <what is said; nothing if it is right>)
function(check text expected)
  file(WRITE ${folder}/board.cmake "${text}")
  execute_process(COMMAND ${CMAKE_COMMAND} -DBOARD=mine -DSHADE16_BOARDS_DIR=${WORK}/boards "-DSHADE16_BOARDS=mine;yours" -P ${WORK}/check.cmake
                  ERROR_VARIABLE said RESULT_VARIABLE status)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")  # CMake wraps long lines
  string(FIND "${said}" "${expected}" at)
  if((expected STREQUAL "" AND NOT status EQUAL 0) OR (NOT expected STREQUAL "" AND (status EQUAL 0 OR at EQUAL -1)))
    message(FATAL_ERROR "Expected '${expected}' of\n${text}\nIt said: ${said}")
  endif()
endfunction()

check("${right}" "")
check("${right}set(BOARD_EMULATER qemu)" "boards/mine/board.cmake says BOARD_EMULATER, which nothing reads; expected one of BOARD_CORE, BOARD_DISPLAY,")
check("${right}set(BOARD_CORE \"\")" "boards/mine/board.cmake says no BOARD_CORE; expected set(BOARD_CORE ..), as docs/boards.md explains.")
check("${right}set(BOARD_TOOLCHAIN arm-none-eaby)" "says BOARD_TOOLCHAIN 'arm-none-eaby'; expected one of")
check("${right}set(BOARD_STARTUP cortex_n)" "says BOARD_STARTUP 'cortex_n'; expected one of arm926, cortex_m,")
check("${right}set(BOARD_CHIP stm32f2)" "says BOARD_CHIP 'stm32f2'; expected one of fe310, rp2040, stm32f4.")
check("${right}set(BOARD_CONSOLE usart)" "says BOARD_CONSOLE 'usart'; expected one of semihosting, uart, simcall.")
check("${right}set(BOARD_FRAMES_OF hers)" "says BOARD_FRAMES_OF 'hers'; expected one of mine, yours.")
file(REMOVE ${folder}/memory.ld)
check("${right}" "boards/mine has no memory.ld; docs/boards.md, step 1, has one to copy.")
