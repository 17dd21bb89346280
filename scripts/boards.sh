#!/usr/bin/env bash
# Makes boards/presets.json of the folders under boards/, so that `cmake --workflow --preset <board>` knows them all.
# usage: scripts/boards.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python3 -B scripts/boards/presets.py --write
