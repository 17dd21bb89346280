#!/usr/bin/env bash
# Boots Debian's kernel under QEMU's TCG with the guest's program, shade16, a model and the cases, and prints what the cases print.
# usage: boot.sh PROGRAM SHADE16 MODEL KERNEL_FOLDER WORK_FOLDER [INIT KERNEL_PARAMETER...]
set -euo pipefail
program=$1 shade16=$2 model=$3 kernel=$4 work=$5 init=${6:-init.sh}
parameters=(console=ttyS0 quiet panic=-1 tsc=reliable spidev.bufsiz=1024 "${@:7}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

root=$work/root
rm -rf "$root"
mkdir -p "$root"/{bin,proc,sys,dev,config,mod,etc}
cp "$(command -v busybox)" "$root/bin/busybox"
"$root/bin/busybox" --list | grep -vx busybox | while read -r name; do ln -s busybox "$root/bin/$name"; done
cp "$program" "$root/bin/guest"
cp "$shade16" "$root/bin/shade16"
strip "$root/bin/guest" "$root/bin/shade16"
ldd "$shade16" | grep -oE '/[^ ]+' | xargs -I @ cp --parents -L @ "$root"  # shade16 is as users have it: with its libraries
cp "$model" "${model%.obj}.mtl" "$root/"
cp "$kernel"/*.ko "$root/mod/"
printf 'root:x:0:\nvideo:x:44:\nspi:x:996:\ngpio:x:997:\n' >"$root/etc/group"
cp "$here"/{asking,cases,spidev_cases,show_cases}.sh "$root/"
cp "$here/$init" "$root/init"
chmod +x "$root/init"
(cd "$root" && find . | cpio --quiet -o -H newc | gzip -1) >"$work/initrd.gz"

timeout 170 qemu-system-x86_64 -machine pc -accel tcg -cpu qemu64 -m 256 -display none -no-reboot -nodefaults -vga std -serial stdio \
  -kernel "$kernel/vmlinuz" -initrd "$work/initrd.gz" -append "${parameters[*]}" \
  </dev/null >"$work/serial.log"
tr -d '\r' <"$work/serial.log" | sed -n 's/^> //p'
