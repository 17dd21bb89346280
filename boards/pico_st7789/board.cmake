include(${CMAKE_CURRENT_LIST_DIR}/../pico.cmake)
set(BOARD_CORE "Cortex-M0+")
set(BOARD_DISPLAY "ST7789, 240x240, SPI at 62.5 MHz by DMA")
set(BOARD_EMULATOR ${PICO_EMULATOR})
set(BOARD_SCREEN_BITS 5 6 5)
set(BOARD_SCREEN_MODEL st7789_240x240 0)  # the panel, and the quarter turns that the picture is meant for
