#!/bin/sh
# The guest's first process: makes a board with a display on spidev and runs the cases of that, then makes two simulated chips and runs the
# cases of lines, which end with a chip that is unplugged while its lines are held: after that, 6.1 does not survive another chip with
# named lines. What the cases print begins with "> " on the serial line, so that nothing of the kernel's is taken for it.
mount -t proc proc /proc; mount -t sysfs sys /sys; mount -t devtmpfs dev /dev 2>/dev/null
mount -t debugfs debug /sys/kernel/debug
echo 1 >/proc/sys/kernel/printk
echo  # after whatever the firmware left on the line

# The display has no driver of its own, so spidev is told to take it, as the kernel's Documentation/spi/spidev.rst says.
[ ! -e /mod/spidev.ko ] || insmod /mod/spidev.ko $(grep -o 'bufsiz=[0-9]*' /proc/cmdline)  # built in, it reads that itself
for module in spi-bitbang spi-gpio wire_recorder wired_panel; do insmod /mod/$module.ko; done
echo spidev >/sys/bus/spi/devices/spi0.0/driver_override; echo spi0.0 >/sys/bus/spi/drivers/spidev/bind
sh /spidev_cases.sh 2>&1 | sed 's/^/> /'
sh /show_cases.sh 2>&1 | sed 's/^/> /'
for module in wired_panel wire_recorder; do rmmod $module; done

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

sh /cases.sh 2>&1 | sed 's/^/> /'
poweroff -f
