#!/usr/bin/env bash
# Installs the Debian packages that shade16 needs and that are missing.
# usage: scripts/setup.sh [--demo]     --demo: only what the demo needs, no cross compilers and no emulator
set -euo pipefail

packages=(cmake ninja-build g++ libglm-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  libtinyobjloader-dev libmeshoptimizer-dev libpng-dev libtomlplusplus-dev zlib1g-dev)
if [[ ${1:-} != --demo ]]; then
  packages+=(
    clang libclang-rt-dev lld libgtest-dev libgmock-dev librapidcheck-dev ffmpeg assimp-testmodels
    gcc-arm-none-eabi binutils-arm-none-eabi libnewlib-arm-none-eabi
    gcc-riscv64-unknown-elf binutils-riscv64-unknown-elf qemu-system-arm qemu-system-misc python3 gappa
    gcc-avr simavr
  )
  command -v node >/dev/null || packages+=(nodejs)  # of whatever origin
fi

if ! command -v dpkg-query >/dev/null; then
  echo "This is not Debian. Please install what these packages hold: ${packages[*]}" >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $state == installed ]] || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
  command -v sudo >/dev/null || { echo "Please install, as root: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600)
"${apt[@]}" update
"${apt[@]}" install --yes --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}" >/dev/null
