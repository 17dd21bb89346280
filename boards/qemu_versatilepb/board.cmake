set(BOARD_TOOLCHAIN arm-none-eabi)
set(BOARD_STARTUP arm926)
set(BOARD_CPU_FLAGS -mcpu=arm926ej-s -marm -mfloat-abi=soft)
set(BOARD_OPTIMIZE -O2)
set(BOARD_EMULATOR qemu-system-arm -M versatilepb -audiodev none,id=silent -global pl041.audiodev=silent -display none -monitor none -serial none -chardev stdio,id=text
                   -semihosting-config enable=on,target=native,chardev=text -kernel)
set(BOARD_SCREEN_BITS 5 6 5)
