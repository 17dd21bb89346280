include(${CMAKE_CURRENT_LIST_DIR}/../qemu.cmake)
set(BOARD_CORE "Cortex-M3")
set(BOARD_DISPLAY "SSD0303, 96x16, black and white, I2C")
set(BOARD_TOOLCHAIN arm-none-eabi)
set(BOARD_STARTUP cortex_m)
set(BOARD_CPU_FLAGS -mcpu=cortex-m3 -mthumb)
set(BOARD_OPTIMIZE -O2)
set(BOARD_EMULATOR qemu-system-arm -M lm3s811evb ${QEMU_SEMIHOSTING})
set(BOARD_SCREEN_BITS 1 1 1)
set(BOARD_TOO_SMALL_FOR_IDENTITY ON)  # the kernels take 142 KB of flash; the processor is the LM3S6965's
set(BOARD_FORGIVES_ACCESS ON)  # the emulator reads zeros where there is no memory
