#!/usr/bin/env bash
# Renders a turning teapot with the code that runs on the microcontroller, and compares it with double precision.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh --demo
cmake --preset host >/dev/null
cmake --build --preset host --target shade16

shade16=$(find build/host -name shade16 -type f -perm -u+x -print -quit)
mkdir -p out
"$shade16" render assets/teapot.obj -o out/teapot.y4m --frames 90 --size 320x240
"$shade16" render assets/teapot.obj -o out/teapot.png --frames 1 --size 320x240
"$shade16" compare assets/teapot.obj

echo
echo "Watch it: ffplay -loop 0 out/teapot.y4m      Look at it: out/teapot.png"
