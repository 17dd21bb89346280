# What QEMU's boards have in common: no window, and what the image says through semihosting is QEMU's own output. The image's name follows.
set(QEMU_SEMIHOSTING -display none -monitor none -serial none -chardev stdio,id=text
                     -semihosting-config enable=on,target=native,chardev=text -kernel)
