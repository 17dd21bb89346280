#!/usr/bin/env bash
# Makes boards/presets.json and the tables of docs/boards.md of the folders under boards/, and the panels' headers of boards/panels.
# usage: scripts/boards.sh              the presets, the tables and the headers
#        scripts/boards.sh --pictures   builds the boards whose displays an emulator shows, and takes their pictures for the page
#        scripts/boards.sh --bench [<board>...]    builds the emulated boards' bench, or those boards' alone, and records what it prints in
#                                                   tests/budget/cycles.csv
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1:-} in
  "" | --pictures | --bench) ;;
  *) echo "scripts/boards.sh $1: expected --pictures, --bench or nothing." >&2; exit 2 ;;
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

record_bench() {
  local file board emulator
  [[ $# -gt 0 ]] || set -- $(grep -l BOARD_EMULATOR boards/*/board.cmake | xargs -n 1 dirname | xargs -n 1 basename)
  for board in "$@"; do
    file=boards/$board/board.cmake
    [[ -e $file ]] || { echo "scripts/boards.sh --bench $board: there is no $file." >&2; exit 2; }
    build "$board" bench
    read -r -a emulator < <(cmake -DBOARD_FILE="$file" -P scripts/bench/emulator.cmake)
    python3 -B scripts/boards/bench.py --bless "$board" "build/$board/firmware/bench.elf" "${emulator[@]}"
  done
}

make_tables
if [[ $# -gt 0 ]]; then
  scripts/setup.sh
  if [[ $1 == --pictures ]]; then take_pictures; else record_bench "${@:2}"; fi
  make_tables
fi
