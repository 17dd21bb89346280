#!/usr/bin/env bash
# Measures every bound with today's engine and puts the tables into docs/bounds.md.
# usage: scripts/bounds.sh           a minute; the page, and out/bounds/bounds.html
#        scripts/bounds.sh --full    every input of every function of one argument, on two cores: hours
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh
cmake --preset host >/dev/null
cmake --build --preset host --target shade16 >&2
shade16=$(find build/host -name shade16 -type f -perm -u+x -print -quit)

if [[ ${1:-} == --full ]]; then
  rm -rf out/bounds-full && mkdir -p out/bounds-full
  shards=()
  for shard in 0 1; do
    "$shade16" report bounds -o "out/bounds-full/$shard" --full --shard "$shard/2" >"out/bounds-full/$shard.txt" &
    shards+=($!)
  done
  for shard in "${shards[@]}"; do wait "$shard" || [[ $? == 1 ]]; done  # 1: a broken bound, which the merged report says
  "$shade16" report bounds -o out/bounds-full --merge out/bounds-full/0/bounds.json out/bounds-full/1/bounds.json
else
  "$shade16" report bounds -o out/bounds
  python3 tests/bounds/page_tables.py docs/bounds.md out/bounds/bounds.md --write
fi
