include(${CMAKE_CURRENT_LIST_DIR}/../pico.cmake)
set(BOARD_CORE "Cortex-M0+")
set(BOARD_DISPLAY "ILI9341, 320x240, SPI at 31.25 MHz by DMA")
set(BOARD_EMULATOR ${PICO_EMULATOR})
set(BOARD_SCREEN_BITS 5 6 5)
set(BOARD_SCREEN_MODEL ili9341 1)  # the panel, and the quarter turns that the picture is meant for
