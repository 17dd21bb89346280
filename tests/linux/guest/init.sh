#!/bin/sh
# The guest's first process: makes two simulated chips and runs the cases of lines, then makes a board with a display on spidev and runs
# the cases of that. What the cases print begins with "> " on the serial line, so that nothing of the kernel's is taken for it.
mount -t proc proc /proc; mount -t sysfs sys /sys; mount -t devtmpfs dev /dev 2>/dev/null
mount -t debugfs debug /sys/kernel/debug
echo 1 >/proc/sys/kernel/printk
insmod /mod/configfs.ko; mount -t configfs none /config; insmod /mod/gpio-sim.ko

# bank0 is the header that the panel is on, in the order of its wires; bank1 has a name twice.
panel=/config/gpio-sim/panel
name_line() { mkdir -p $panel/$1; echo "$2" >$panel/$1/name; }
mkdir -p $panel/bank0 $panel/bank1
echo 8 >$panel/bank0/num_lines; echo pinctrl-sim >$panel/bank0/label
echo 2 >$panel/bank1/num_lines; echo expander >$panel/bank1/label
for line in 0:GPIO11 1:GPIO10 2:GPIO25 3:GPIO27 4:GPIO18 5:GPIO8 7:TWIN; do name_line bank0/line${line%:*} ${line#*:}; done
name_line bank1/line0 TWIN
echo 1 >$panel/live

echo  # after whatever the firmware left on the line
sh /cases.sh 2>&1 | sed 's/^/> /'

# A display has no driver of its own, so spidev is told to take it, as the kernel's Documentation/spi/spidev.rst says.
echo 0 >$panel/live
for module in spidev spi-bitbang spi-gpio wire_recorder wired_panel; do
  [ ! -e /mod/$module.ko ] || insmod /mod/$module.ko $(grep -o "$module[.][^ ]*" /proc/cmdline | cut -d . -f 2)
done
echo spidev >/sys/bus/spi/devices/spi0.0/driver_override; echo spi0.0 >/sys/bus/spi/drivers/spidev/bind
sh /spidev_cases.sh 2>&1 | sed 's/gpiochip[0-9]*/gpiochipN/; s/^/> /'  # chance says which numbers are free
echo "> == end"
poweroff -f
