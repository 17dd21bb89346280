#!/bin/sh
# The guest's first and only process: makes two simulated chips and runs the cases. What the cases print begins with "> " on the serial
# line, so that nothing of the kernel's is taken for it.
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
poweroff -f
