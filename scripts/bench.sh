#!/usr/bin/env bash
# Counts the instructions of the benchmark scenes on the emulated boards: scripts/bench.sh --help
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

command -v python3 >/dev/null || scripts/setup.sh
exec python3 -B scripts/bench "$@"
