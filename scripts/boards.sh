#!/usr/bin/env bash
# Makes boards/presets.json and the tables of docs/boards.md of the folders under boards/, and the panels' headers of boards/panels.
# usage: scripts/boards.sh              the presets, the tables and the headers
#        scripts/boards.sh --pictures   builds the boards whose displays an emulator shows, and takes their pictures for the page
#        scripts/boards.sh --measure [<board>...]    builds the emulated boards, or those boards alone, and records what a frame costs them in
#                                                     tests/budget/cycles.csv and how much stack it takes in tests/budget/stacks.csv
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1:-} in
  "" | --pictures | --measure) ;;
  *) echo "scripts/boards.sh $1: expected --pictures, --measure or nothing." >&2; exit 2 ;;
esac

make_tables() {
  python3 -B scripts/boards/presets.py --write
  python3 -B scripts/boards/table.py --write
  python3 -B scripts/boards/panels.py --write
  python3 -B scripts/boards/bus.py --write
}
build() {
  local log
  cmake --preset "$1" >/dev/null
  log=$(cmake --build --preset "$1" --target "$2") || { echo "$log" >&2; return 1; }
}

take_pictures() {
  build host decode_display
  local file board
  for file in boards/*/board.cmake; do
    board=$(basename "$(dirname "$file")")
    grep -q BOARD_SCREEN_BITS "$file" || continue
    build "$board" turntable
    build host "turntable_$board"
    cmake -DBOARD="$board" -DHOST_PROGRAM="build/host/firmware/turntable_$board" -DIMAGE="build/$board/firmware/turntable.elf" \
      -DDECODER=build/host/tests/decode_display -DKEEP="docs/img/boards/$board.png" -P tests/boards/screen.cmake
  done
}

emulated_boards() { grep -l BOARD_EMULATOR boards/*/board.cmake | xargs -n 1 dirname | xargs -n 1 basename; }

measure() {
  local file board emulator
  [[ $# -gt 0 ]] || set -- $(emulated_boards)
  for board in "$@"; do
    file=boards/$board/board.cmake
    [[ -e $file ]] || { echo "scripts/boards.sh --measure $board: there is no $file." >&2; exit 2; }
    build "$board" turntable
    build "$board" bench
    read -r -a emulator < <(cmake -DBOARD_FILE="$file" -P scripts/bench/emulator.cmake)
    python3 -B scripts/boards/bench.py --bless "$board" "build/$board/firmware/bench.elf" "${emulator[@]}"
    python3 -B scripts/boards/stacks.py --bless "$board" "build/$board/firmware/turntable.elf"
  done
}

make_tables
if [[ $# -gt 0 ]]; then
  scripts/setup.sh
  case $1 in
    --pictures) take_pictures ;;
    --measure) measure "${@:2}" ;;
  esac
  make_tables
fi
