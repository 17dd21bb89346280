# What both Picos have in common. Their emulator is an interpreter, so that kernels get few arguments.
set(BOARD_TOOLCHAIN arm-none-eabi)
set(BOARD_STARTUP cortex_m)
set(BOARD_CHIP rp2040)
set(BOARD_CONSOLE uart)
set(BOARD_CPU_FLAGS -mcpu=cortex-m0plus -mthumb)
set(BOARD_OPTIMIZE -O2)
set(BOARD_IDENTITY_INPUTS 1000)
set(BOARD_UF2 ON)
set(PICO_EMULATOR node ${CMAKE_CURRENT_LIST_DIR}/../tests/boards/rp2040/run.mjs)
set(BOARD_FORGIVES_ACCESS ON)  # the emulator reads ones where there is no memory
