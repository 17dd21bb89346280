#!/bin/sh
# The guest's first process where the kernel has a framebuffer: `shade16 show --board fbdev` draws on it, and what is there is read back.
mount -t proc proc /proc; mount -t sysfs sys /sys; mount -t devtmpfs dev /dev 2>/dev/null
echo 1 >/proc/sys/kernel/printk
echo  # after whatever the firmware left on the line
fb=/sys/class/graphics/fb0

# The console gets its cursor back when the program ends, and that stands in the picture: here it is hidden for good.
printf '\033[?25l' >/dev/tty0
rm /dev/tty0

cases() {
  echo "== $(cat /proc/fb), $(cat $fb/virtual_size), $(cat $fb/bits_per_pixel) bits, rows of $(cat $fb/stride) bytes"
  for frames in 1 3; do
    shade16 show /teapot.obj --board fbdev --frames $frames --quiet
    echo "exit code $?, $(guest framebuffer_hash /dev/fb0 $(cat $fb/bits_per_pixel) 64000)"
  done
  shade16 show --probe --board fbdev
  chmod 600 /dev/fb0; guest as 1000 become shade16 show --probe --board fbdev
  chgrp 44 /dev/fb0; chmod 660 /dev/fb0; guest as 1000 become shade16 show /teapot.obj --board fbdev; echo "exit code $?"
}
cases 2>&1 | sed 's/^/> /'
poweroff -f
