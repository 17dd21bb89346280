# `shade16 show` itself, as a user has it, over Debian's spidev and the real libgpiod, on the lines of the wire recorder.
. /asking.sh
wires="--panel st7735_80x160 --rotate 90 --dc panel-command --reset panel-reset --backlight panel-light"
driver=/sys/bus/spi/drivers/spidev
show() { echo "watch shade16 show /teapot.obj $wires $*"; }

# How many frames there were, and which was the last, is chance.
some="s/^shown: .*/shown: some frames/; s/^lost: .*/lost: some frames/; /^seen /d"
wait_for() { until grep -q "$1" /said; do usleep 20000; done; }

cases() {
  echo "== shade16 show: a frame"; run $(show --frames 1 --quiet)
  echo "== the third frame, of which only some rows were sent"; run $(show --frames 3 --quiet --off)
  echo "== SIGTERM"; start lit $(show --off --fps 5); kill -TERM $!; ended "$some"
  echo "== taken away and given back"
  start lit $(show --fps 5); echo spi0.0 >$driver/unbind; wait_for "no such device"
  echo spi0.0 >$driver/bind; wait_for back; kill -TERM $!; ended "$some"
  echo "== --probe"; run become shade16 show --probe $wires
  chmod 600 /dev/gpiochip*; chgrp 996 /dev/spidev0.0; chmod 660 /dev/spidev0.0
  echo "== --probe without rights"; run as 1000 become shade16 show --probe $wires
}
cases 2>&1 | sed "/^in use: .*, by '\(sck\|mosi\|cs\)'$/d"
