set(BOARD_CORE "RV32IMAC")
set(BOARD_DISPLAY "none: frames are hashed")
set(BOARD_TOOLCHAIN riscv-none-elf)
set(BOARD_STARTUP riscv)
set(BOARD_CPU_FLAGS -march=rv32imac -mabi=ilp32 -mcmodel=medany)
set(BOARD_OPTIMIZE -O2)
set(BOARD_EMULATOR qemu-system-riscv32 -M sifive_e -display none -monitor none -serial none -chardev stdio,id=text
                   -semihosting-config enable=on,target=native,chardev=text -kernel)
set(BOARD_FRAMES_OF qemu_microbit)
