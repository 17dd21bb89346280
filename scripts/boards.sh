#!/usr/bin/env bash
# Makes boards/presets.json and the table of docs/boards.md of the folders under boards/.
# usage: scripts/boards.sh              the presets and the table
#        scripts/boards.sh --stacks     builds the turntable of the emulated boards, records how much stack it uses, and makes the table
#        scripts/boards.sh --pictures   builds the boards whose displays an emulator shows, and takes their pictures for the page
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python3 -B scripts/boards/presets.py --write
if [[ ${1:-} == --stacks ]]; then
  scripts/setup.sh
  for folder in boards/*/; do
    board=$(basename "$folder")
    grep -q BOARD_EMULATOR "$folder/board.cmake" || continue
    cmake --preset "$board" >/dev/null
    cmake --build --preset "$board" --target turntable >/dev/null
  done
  python3 -B scripts/boards/stacks.py --bless
fi
python3 -B scripts/boards/table.py --write
[[ ${1:-} == --pictures ]] || exit 0

scripts/setup.sh
cmake --preset host >/dev/null
cmake --build --preset host --target decode_display >/dev/null
for folder in boards/*/; do
  board=$(basename "$folder")
  grep -q BOARD_SCREEN_BITS "$folder/board.cmake" || continue
  cmake --preset "$board" >/dev/null
  cmake --build --preset "$board" --target turntable >/dev/null
  cmake --build --preset host --target "turntable_$board" >/dev/null
  cmake -DBOARD="$board" -DHOST_PROGRAM="build/host/firmware/turntable_$board" -DIMAGE="build/$board/firmware/turntable.elf" \
    -DDECODER=build/host/tests/decode_display -DKEEP="docs/img/boards/$board.png" -P tests/boards/screen.cmake
done
