#!/usr/bin/env bash
# Builds and tests everything: the boards, two compilers, the sanitizers, the fuzzers, and last the full host run with its summary.
# A missing tool skips its tests; SHADE16_REQUIRE_ALL=1 makes it a failure.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh

say() { printf '\n== %s\n' "$*"; }
build() { cmake --preset "$1" >/dev/null && cmake --build --preset "$@"; }

for folder in boards/*/; do
  board=$(basename "$folder")
  if grep -q BOARD_EMULATOR "$folder/board.cmake"; then
    say "$board"
    build "$board"
    ctest --preset "$board"
  fi
done

say "host, clang"
build host-clang
ctest --preset host-clang --label-regex unit

say "host, address and undefined-behaviour sanitizers"
build host-sanitize --target checks
ctest --preset host-sanitize --label-regex 'unit|raster|golden|accuracy|extremes'

say "host, fuzzers and random frames"
build host-fuzz
ctest --preset host-fuzz

say "host"
build host
ctest --preset host
