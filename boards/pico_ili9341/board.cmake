set(BOARD_CORE "Cortex-M0+")
set(BOARD_DISPLAY "ILI9341, 320x240, SPI at 31.25 MHz by DMA")
set(BOARD_TOOLCHAIN arm-none-eabi)
set(BOARD_STARTUP cortex_m)
set(BOARD_CONSOLE rp2040)
set(BOARD_CPU_FLAGS -mcpu=cortex-m0plus -mthumb)
set(BOARD_OPTIMIZE -O2)
set(BOARD_EMULATOR node ${CMAKE_CURRENT_LIST_DIR}/../../tests/boards/rp2040/run.mjs)
set(BOARD_SCREEN_BITS 5 6 5)
set(BOARD_SCREEN_MODEL ili9341 1)  # the panel, and the quarter turns that the picture is meant for
set(BOARD_IDENTITY_INPUTS 1000)  # the emulator is an interpreter
set(BOARD_UF2 ON)
