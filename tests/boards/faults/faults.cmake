# Programs that go wrong, an image each: every one must end with a sentence and a status that is not 0.
set(stopped "The processor stopped at address 0x[0-9a-f]+ with exception")

# What each start-up calls the two: exception numbers of Cortex-M (3, the hard fault, takes all that are not enabled), vectors of an
# Arm926, causes of RISC-V and of Xtensa.
set(cortex_m_exceptions 3 3)
set(arm926_exceptions 4 1)
set(riscv_exceptions 5 2)
set(lx106_exceptions 15 0)
list(GET ${BOARD_STARTUP}_exceptions 0 no_memory)
list(GET ${BOARD_STARTUP}_exceptions 1 no_instruction)

# shade16_fault_test(<function of fault.cpp> <sentence> <status>)
list(JOIN BOARD_EMULATOR " " emulator)
function(shade16_fault_test fault sentence status)
  shade16_add_image(fault_${fault} ${CMAKE_CURRENT_SOURCE_DIR}/boards/faults/fault.cpp)
  target_compile_definitions(fault_${fault} PRIVATE SHADE16_FAULT=${fault})
  shade16_add_script_test(fault.${fault} LABEL boards SCRIPT boards/faults/fault.cmake
    IMAGE=$<TARGET_FILE:fault_${fault}> "EMULATOR=${emulator}" "SENTENCE=${sentence}" STATUS=${status} "HINT=${hint}")
endfunction()

shade16_fault_test(leave_stack "The stack has run over the variables\\." 1)
shade16_fault_test(wait_for_nobody "Nobody answers\\." 1)
shade16_fault_test(fail_quietly "The program ended with status 3\\." 3)
# rp2040js knows no faults: it steps over what is no instruction.
if(NOT BOARD_CHIP STREQUAL "rp2040")
  shade16_fault_test(run_nonsense "${stopped} ${no_instruction}\\." 1)
endif()
set(hint "Where the emulator forgives what a chip would not, board.cmake says set(BOARD_FORGIVES_ACCESS ON), or BOARD_SOMETHING_BELOW_RAM if leave_memory alone fails.")
if(NOT BOARD_FORGIVES_ACCESS)
  shade16_fault_test(read_nothing "${stopped} ${no_memory}\\." 1)
  if(NOT BOARD_SOMETHING_BELOW_RAM)
    shade16_fault_test(leave_memory "The stack has run over the variables\\." 1)
  endif()
endif()
