#!/usr/bin/env bash
# Installs what shade16 needs and what is missing: Debian packages, and the emulator of tests/boards/rp2040 from npm.
# usage: scripts/setup.sh [--demo]     --demo: only what the demo needs, no cross compilers and no emulator
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(cmake ninja-build g++ libglm-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  libtinyobjloader-dev libmeshoptimizer-dev libpng-dev libtomlplusplus-dev zlib1g-dev libgpiod-dev)
if [[ ${1:-} != --demo ]]; then
  packages+=(
    clang libclang-rt-dev lld libgtest-dev libgmock-dev librapidcheck-dev ffmpeg assimp-testmodels
    gcc-arm-none-eabi binutils-arm-none-eabi libnewlib-arm-none-eabi
    gcc-riscv64-unknown-elf binutils-riscv64-unknown-elf qemu-system-arm qemu-system-misc python3 gappa
    gcc-avr simavr gcc-xtensa-lx106 binutils-xtensa-lx106 rustc
    qemu-system-x86 busybox-static cpio make gcc kmod libelf1 xz-utils
  )
  command -v node >/dev/null || packages+=(nodejs)  # of whatever origin
  command -v npm >/dev/null || packages+=(npm)
fi

install_debian_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "This is not Debian. Please install what these packages hold: ${packages[*]}" >&2
    return
  fi

  local package state missing=()
  for package in "${packages[@]}"; do
    state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $state == installed ]] || missing+=("$package")
  done
  [[ ${#missing[@]} -gt 0 ]] || return 0

  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null || { echo "Please install, as root: ${missing[*]}" >&2; exit 1; }
    as_root=(sudo)
  fi

  echo "Installing ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600)
  "${apt[@]}" update
  "${apt[@]}" install --yes --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}" >/dev/null
}

install_npm_packages() {
  local folder=tests/boards/rp2040
  cmp -s $folder/package-lock.json $folder/node_modules/.installed && return
  echo "Installing the packages of $folder"
  npm ci --prefix $folder --no-audit --no-fund --loglevel error >/dev/null
  cp $folder/package-lock.json $folder/node_modules/.installed
}

install_debian_packages
[[ ${1:-} == --demo ]] || install_npm_packages
