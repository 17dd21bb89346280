#!/usr/bin/env bash
# Fetches what the Linux guest of tests/linux/guest boots: Debian's kernel, the drivers gpio-sim and spi-gpio, which Debian leaves out,
# built of Debian's own source, and the modules of tests/linux/guest/kernel. About 225 MB come down once; kept are 25 MB in build/guest:
# the kernel, its modules, and its headers as packages, so that a change of our modules asks nothing of the network.
# Nothing is installed: the headers are unpacked for a build and thrown away.
# usage: scripts/guest.sh           nothing where all is there and of today's sources
#        scripts/guest.sh --fresh   the kernel that Debian has now
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1:-} in
  "" | --fresh) ;;
  *) echo "scripts/guest.sh $1: expected --fresh or nothing." >&2; exit 2 ;;
esac

keep=$PWD/build/guest
work=$keep/work
own_sources=$PWD/tests/linux/guest/kernel
[[ ${1:-} == --fresh ]] && rm -rf "$keep"

has_debian() {
  local file
  for file in vmlinuz {configfs,spi-bitbang,gpio-sim,spi-gpio}.ko headers version; do  # an older cache has fewer
    [[ -e $keep/$file ]] || return 1
  done
}
has_own() { diff -rq "$own_sources" "$keep/own" >/dev/null 2>&1; }  # what they were built of; copied last
has_debian && has_own && exit 0

for program in apt-get apt-cache dpkg-deb make gcc xz diff; do
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

unpack_headers() {
  local deb
  for deb in "$keep"/headers/*.deb; do dpkg-deb -x "$deb" "$work/root"; done
  # They expect to be installed; their Makefile says where the common half is.
  sed -i "s|/usr/src/|$work/root/usr/src/|" "$work"/root/usr/src/linux-headers-"$version"/Makefile
}

# Builds the modules of a folder with a Makefile, and keeps them.
build() {
  make -s -C "$work/root/usr/src/linux-headers-$version" M="$1" "${@:2}" modules >"$1/make.log" 2>&1 || { cat "$1/make.log" >&2; return 1; }
  strip --strip-debug "$1"/*.ko
  cp "$1"/*.ko "$keep/"
}

# A module of Debian's, as insmod takes it.
keep_module() {
  local file
  file=$(find "$work/root/lib" -name "$1.ko*")
  case $file in
    *.xz) xz -dc "$file" >"$keep/$1.ko" ;;
    *.ko) cp "$file" "$keep/$1.ko" ;;
    *) echo "Debian's kernel $version has no $1.ko." >&2; return 1 ;;
  esac
}

keep_debian() {
  local deb
  mkdir "$work/debs"
  cd "$work/debs"
  fetch || { update_lists && fetch; } || return 1  # the archive keeps only the newest kernels
  rm -rf "$keep"/{version,own,headers,*.ko}
  mkdir "$keep/headers"
  for deb in linux-{headers,kbuild,compiler}-*.deb; do
    [[ ! -e $deb ]] || mv "$deb" "$keep/headers/"
  done
  dpkg-deb --fsys-tarfile "$image"_*.deb |
    tar -x -C "$work/root" --wildcards './boot/vmlinuz-*' '*/fs/configfs/configfs.ko*' '*/drivers/spi/spi*.ko*'
  cp "$work/root/boot/vmlinuz-$version" "$keep/vmlinuz"
  keep_module configfs
  keep_module spi-bitbang
  keep_module spidev 2>/dev/null || true  # Debian 12 has it built in
  unpack_headers
  build_drivers
  echo "$version" >"$keep/version"
}

# irq_sim.c is not a module's: it uses irq_to_desc, which the kernel keeps to itself. What stands there instead does the same.
build_drivers() {
  local drivers=$work/drivers
  mkdir "$drivers"
  dpkg-deb --fsys-tarfile "$source_tree"_*.deb | tar -xO "./usr/src/$source_tree.tar.xz" |
    tar -xJ -C "$drivers" --transform 's|.*/||' "$source_tree"/kernel/irq/irq_sim.c \
      "$source_tree"/drivers/{gpio/gpio-sim.c,gpio/gpiolib.h,spi/spi-gpio.c,spi/spi-bitbang-txrx.h}
  mv "$drivers/gpio-sim.c" "$drivers/gpio-sim-main.c"
  sed -i 's/handle_simple_irq(irq_to_desc(\(.*\)));/generic_handle_irq_safe(\1);/' "$drivers/irq_sim.c"
  printf 'obj-m := gpio-sim.o spi-gpio.o\ngpio-sim-y := gpio-sim-main.o irq_sim.o\nccflags-y := -I$(src)\n' >"$drivers/Makefile"
  build "$drivers"
}

build_own() {
  echo "Building the modules of tests/linux/guest/kernel for $version"
  rm -rf "$keep/own"
  cp -r "$own_sources" "$work/own"
  build "$work/own" KCFLAGS=-Werror
  cp -r "$own_sources" "$keep/own"
}

rm -rf "$work"
mkdir -p "$work/root"
if has_debian; then
  version=$(<"$keep/version")
  unpack_headers
else
  keep_debian
fi
build_own
rm -rf "$work"
