#!/usr/bin/env bash
# Builds and tests everything: the boards, two compilers, the sanitizers, the fuzzers, and last the full host run with its summary.
# A missing tool skips its tests; SHADE16_REQUIRE_ALL=1 makes it a failure.
# usage: scripts/test.sh            everything
#        scripts/test.sh boards     every board built, every emulated one run, and what it draws and shows compared with this computer
#        scripts/test.sh errors     what is about errors alone: bounds, promises, proofs, extremes, identity of bits, fuzzers;
#                                    not the tests of the programs
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1:-everything} in
  everything | boards | errors) share=${1:-everything} ;;
  *) echo "scripts/test.sh $1: expected boards, errors, or nothing for every test." >&2; exit 2 ;;
esac

scripts/setup.sh

say() { printf '\n== %s\n' "$*"; }
build() { cmake --preset "$1" >/dev/null && cmake --build --preset "$@"; }
# Runs a test preset of every board that is named, two at a time: most have one long test.
test_boards() {
  local label=$1
  shift
  printf '%s\n' "$@" | xargs -P 2 -I @ bash -c \
    'log=$(ctest --preset @ --parallel 1 --label-regex "$0" 2>&1); status=$?; printf "\n== %s, tests\n%s\n" @ "$log"; exit $status' "$label"
}
emulated_boards() {
  local file
  for file in boards/*/board.cmake; do
    if grep -q BOARD_EMULATOR "$file"; then basename "$(dirname "$file")"; fi
  done
}

if [[ $share == errors ]]; then
  mapfile -t boards < <(emulated_boards | while read -r board; do
    grep -q BOARD_TOO_SMALL_FOR_IDENTITY "boards/$board/board.cmake" || echo "$board"
  done)
  for board in "${boards[@]}"; do
    say "$board, the same bits"
    build "$board" --target identity
  done
  test_boards identity "${boards[@]}"
  say "host, extremes with sanitizers"
  build host-sanitize --target unit_tests extremes_tests
  ctest --preset host-sanitize --tests-regex '^(unit|extremes)_tests$'
  say "host, fuzzers and random frames"
  build host-fuzz
  ctest --preset host-fuzz
  say "host, errors"
  build host --target errors
  ctest --preset host --label-regex '^(bounds|proof|extremes|identity|accuracy|unit|raster|compile_fail)$' --exclude-regex '^renderer_tests$'
  exit
fi

for file in boards/*/board.cmake; do  # linux_spi and panels are no microcontrollers
  board=$(basename "$(dirname "$file")")
  say "$board"
  build "$board"
done
mapfile -t boards < <(emulated_boards)
test_boards . "${boards[@]}"

if [[ $share == boards ]]; then
  say "host, against the boards"
  build host --target board_checks
  ctest --preset host --label-regex boards
  exit
fi

say "host, clang"
build host-clang
ctest --preset host-clang --label-regex unit

say "host, address and undefined-behaviour sanitizers"
build host-sanitize --target sanitized
ctest --preset host-sanitize --label-regex 'unit|raster|golden|accuracy|extremes'

say "host, fuzzers and random frames"
build host-fuzz
ctest --preset host-fuzz

say "host"
scripts/guest.sh || [[ ${SHADE16_REQUIRE_ALL:-} != 1 ]]  # without its kernel the guest's test skips
build host
ctest --preset host
