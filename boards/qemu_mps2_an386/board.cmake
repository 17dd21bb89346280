set(BOARD_TOOLCHAIN arm-none-eabi)
set(BOARD_STARTUP cortex_m)
set(BOARD_CPU_FLAGS -mcpu=cortex-m4 -mthumb -mfloat-abi=soft)
set(BOARD_OPTIMIZE -O2)
set(BOARD_SCENES ON)
set(BOARD_EMULATOR qemu-system-arm -M mps2-an386 -display none -monitor none -serial none -chardev stdio,id=text
                   -semihosting-config enable=on,target=native,chardev=text -kernel)
