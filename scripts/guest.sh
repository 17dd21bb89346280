#!/usr/bin/env bash
# Fetches what the Linux guest of tests/linux/guest boots: Debian's kernel, and gpio-sim, which Debian leaves out, built of Debian's own
# source. About 225 MB come down once; kept are build/guest/{vmlinuz,configfs.ko,gpio-sim.ko,version}, 9 MB.
# Nothing is installed: the kernel's headers are unpacked for the build and thrown away.
# usage: scripts/guest.sh           nothing where all is there
#        scripts/guest.sh --fresh   the kernel that Debian has now
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1:-} in
  "" | --fresh) ;;
  *) echo "scripts/guest.sh $1: expected --fresh or nothing." >&2; exit 2 ;;
esac

keep=$PWD/build/guest
[[ ${1:-} == --fresh ]] && rm -rf "$keep"
[[ -e $keep/version ]] && exit 0  # written last

for program in apt-get apt-cache dpkg-deb make gcc xz; do
  command -v $program >/dev/null || { echo "scripts/guest.sh needs $program, which is not installed." >&2; exit 1; }
done

# What a package depends on, of the kernel's own packages.
kernel_packages_of() { apt-cache depends "$1" | awk '$1 == "Depends:" && $2 ~ /^linux-/ {print $2}'; }

# Sets image, version, headers and source_tree, and leaves the packages in this folder.
fetch() {
  image=$(kernel_packages_of linux-image-amd64)
  [[ $image == linux-image-* ]] || { echo "linux-image-amd64 names no kernel." >&2; return 1; }
  version=${image#linux-image-}
  headers=linux-headers-$version
  source_tree=linux-source-$(grep -oE '^[0-9]+\.[0-9]+' <<<"$version")
  echo "Fetching Debian's kernel $version and its source"
  # shellcheck disable=SC2046  # a list of packages
  apt-get -qq -o APT::Sandbox::User=root download "$image" "$headers" $(kernel_packages_of "$headers") "$source_tree"
}
update_lists() {
  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null || { echo "Please run, as root: apt-get update" >&2; return 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get -qq -o DPkg::Lock::Timeout=600 update
}

work=$keep/work
rm -rf "$work"
mkdir -p "$work/debs" "$work/root" "$work/module"
cd "$work/debs"
fetch || { update_lists && fetch; } || exit 1  # the archive keeps only the newest kernels

for deb in linux-headers-* linux-kbuild-* linux-compiler-*; do
  [[ ! -e $deb ]] || dpkg-deb -x "$deb" "$work/root"
done
dpkg-deb --fsys-tarfile "$image"_*.deb | tar -x -C "$work/root" --wildcards './boot/vmlinuz-*' '*/fs/configfs/configfs.ko*'
dpkg-deb --fsys-tarfile "$source_tree"_*.deb | tar -xO "./usr/src/$source_tree.tar.xz" |
  tar -xJ -C "$work" "$source_tree"/{drivers/gpio/gpio-sim.c,drivers/gpio/gpiolib.h,kernel/irq/irq_sim.c}

# irq_sim.c is not a module's: it uses irq_to_desc, which the kernel keeps to itself. What stands there instead does the same.
cd "$work/module"
cp "$work/$source_tree/drivers/gpio/gpio-sim.c" gpio-sim-main.c
cp "$work/$source_tree"/{drivers/gpio/gpiolib.h,kernel/irq/irq_sim.c} .
sed -i 's/handle_simple_irq(irq_to_desc(\(.*\)));/generic_handle_irq_safe(\1);/' irq_sim.c
printf 'obj-m := gpio-sim.o\ngpio-sim-y := gpio-sim-main.o irq_sim.o\nccflags-y := -I$(src)\n' >Makefile
# The headers expect to be installed; their Makefile says where the common half is.
sed -i "s|/usr/src/|$work/root/usr/src/|" "$work/root/usr/src/$headers/Makefile"
make -s -C "$work/root/usr/src/$headers" M="$PWD" modules >make.log 2>&1 || { cat make.log >&2; exit 1; }

cp gpio-sim.ko "$work/root/boot/vmlinuz-$version" "$keep/"
mv "$keep/vmlinuz-$version" "$keep/vmlinuz"
configfs=$(find "$work/root" -name 'configfs.ko*')
case $configfs in
  *.xz) xz -dc "$configfs" >"$keep/configfs.ko" ;;
  *.ko) cp "$configfs" "$keep/configfs.ko" ;;
  *) echo "Debian's kernel $version has no configfs.ko." >&2; exit 1 ;;
esac
strip --strip-debug "$keep"/*.ko
rm -rf "$work"
echo "$version" >"$keep/version"
