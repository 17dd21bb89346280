set(BOARD_CORE "Cortex-M7")
set(BOARD_DISPLAY "none: frames are hashed")
set(BOARD_TOOLCHAIN arm-none-eabi)
set(BOARD_STARTUP cortex_m)
set(BOARD_CPU_FLAGS -mcpu=cortex-m7 -mthumb -mfloat-abi=soft)
set(BOARD_OPTIMIZE -O2)
set(BOARD_EMULATOR qemu-system-arm -M mps2-an500 -display none -monitor none -serial none -chardev stdio,id=text
                   -semihosting-config enable=on,target=native,chardev=text -kernel)
set(BOARD_FRAMES_OF qemu_mps2_an385)
