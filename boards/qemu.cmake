# What QEMU's boards have in common: no window, and what the image says through semihosting is QEMU's own output. The image's name follows.
set(QEMU_SEMIHOSTING -display none -monitor none -serial none -chardev stdio,id=text
                     -semihosting-config enable=on,target=native,chardev=text -kernel)
# The first or the second serial line as QEMU's own output.
set(QEMU_SERIAL_0 -display none -monitor none -serial stdio -kernel)
set(QEMU_SERIAL_1 -display none -monitor none -serial null -serial stdio -kernel)
