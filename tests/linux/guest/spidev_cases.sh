# Every case of spidev: Debian's own driver, over spi-gpio, on the lines of the wire recorder. The kernel itself holds three of them.
. /asking.sh
device=/dev/spidev0.0
driver=/sys/bus/spi/drivers/spidev

cases() {
  for how in mode_0 mode_3 untold; do echo "== a frame over spidev: $how"; run show_on_spidev $device $how; done
  echo "== a mode that spi-gpio does not have: SPI_LOOP"; run try_spidev $device 32
  echo "== no such SPI"; run try_spidev /dev/spidev9.0 0
  echo "== no permission for SPI"
  chmod 600 $device; run as 1000 try_spidev $device 0
  chgrp 996 $device; chmod 660 $device; run as 1000 try_spidev $device 0
  echo "== SIGTERM in mid-frame over spidev"; start drawing draw_on_spidev $device; kill -TERM $!; ended
  echo "== SIGKILL in mid-frame over spidev"; start drawing draw_on_spidev $device; kill -KILL $!; ended
  echo "== the display is taken from spidev in mid-frame"
  start drawing draw_on_spidev $device; echo spi0.0 >$driver/unbind; ended; run try_spidev $device 0
  echo "== given back to spidev"; echo spi0.0 >$driver/bind; run show_on_spidev $device mode_0
}

echo "== spidev"; ls /dev/spidev*; cat /sys/module/spidev/parameters/bufsiz; guest used
cases 2>&1 | sed "/^in use: .*, by '\(sck\|mosi\|cs\)'$/d"  # still the kernel's three: their number is enough
