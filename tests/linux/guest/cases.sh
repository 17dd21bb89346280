# Every case of lines that a program sets.
simulated=/sys/devices/platform/$(cat /config/gpio-sim/panel/dev_name)/$(cat /config/gpio-sim/panel/bank0/chip_name)
live=/config/gpio-sim/panel/live

. /asking.sh

# Which line of a chip that goes is the next to be set is chance: the clock, the data or the command line.
whichever="s/^line '\(GPIO11\|GPIO10\|25\)'/line 'GPIO11, GPIO10 or 25'/"

echo "== what is there"; ls /dev/gpiochip*; guest used
echo "== a frame"; run show "$simulated"
echo "== lines by name, by number and by chip and offset"; run try GPIO25; run try 25; run try 6; run try gpiochip1:1; run try /dev/gpiochip0:7
echo "== a line that is active low"; run low "$simulated"
echo "== a busy line"; start holding hold GPIO25 "another program"; guest used; run try GPIO25; kill $!; ended
echo "== a name that does not exist"; run try GPI025
echo "== two lines of one name"; run try TWIN
echo "== no such chip, no such line"; run try gpiochip7:1; run try gpiochip1:2
echo "== no permission"
chmod 600 /dev/gpiochip*; run as 1000 try GPIO25
chgrp 997 /dev/gpiochip*; chmod 660 /dev/gpiochip*; run as 1000 try GPIO25
echo "== SIGTERM in mid-frame"; start drawing draw "$simulated"; guest used | tail -n 1; kill -TERM $!; ended
echo "== SIGHUP in mid-frame"; start drawing draw "$simulated"; kill -HUP $!; ended
echo "== SIGINT in mid-frame"; start drawing in_the_foreground draw "$simulated"; kill -INT $!; ended
echo "== SIGKILL in mid-frame"; start drawing draw "$simulated"; kill -KILL $!; ended
echo "== the chip is unplugged in mid-frame"; start drawing draw "$simulated"; echo 0 >$live; ended "$whichever"; ls /dev/gpiochip*; run try GPIO25
# The chips' new numbers are the kernel's affair: 6.1 gives none again whose lines were held when it went.
echo "== plugged in again"; echo 1 >$live; ls /dev/gpiochip* | wc -l; run try GPIO25
echo "== end"
