set(BOARD_CORE "Cortex-M3")
set(BOARD_DISPLAY "SSD0323, 128x64, 16 greys, SSI")
set(BOARD_TOOLCHAIN arm-none-eabi)
set(BOARD_STARTUP cortex_m)
set(BOARD_CPU_FLAGS -mcpu=cortex-m3 -mthumb)
set(BOARD_OPTIMIZE -O2)
set(BOARD_EMULATOR qemu-system-arm -M lm3s6965evb -display none -monitor none -serial none -chardev stdio,id=text
                   -semihosting-config enable=on,target=native,chardev=text -kernel)
set(BOARD_SCREEN_BITS 4 4 4)
