#!/usr/bin/env bash
# Draws the pictures of docs/gallery.md with today's engine, and prints the figures that the page quotes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh --demo
cmake --preset host >/dev/null
cmake --build --preset host --target shade16 >&2

shade16=$(find build/host -name shade16 -type f -perm -u+x -print -quit)
mkdir -p docs/gallery
"$shade16" gallery assets -o docs/gallery
