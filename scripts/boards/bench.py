#!/usr/bin/env python3
"""What firmware/apps/bench.cpp prints on an emulated board, against tests/budget/cycles.csv.

QEMU counts no cycles: its clock goes on by the instruction (-icount), and bench's yardstick says by how much. So these are instructions there,
and cycles in rp2040js.

usage: bench.py BOARD IMAGE EMULATOR...    exit code 1 where a stage takes another number
       bench.py --bless BOARD IMAGE EMULATOR...    records today's
"""
import csv
import re
import subprocess
import sys
from pathlib import Path

FILE = Path(__file__).resolve().parents[2] / "tests" / "budget" / "cycles.csv"
COLUMNS = ["board", "stage", "count", "unit"]
TOLERANCE_PERCENT = 1
INSTRUCTIONS_A_TURN = 2


def recorded() -> dict[tuple[str, str], tuple[int, str]]:
    """{(board, stage): (count, unit)}; the bus is a stage whose unit is its clock."""
    if not FILE.exists():
        return {}
    with FILE.open(newline="") as file:
        return {(row["board"], row["stage"]): (int(row["count"]), row["unit"]) for row in csv.DictReader(file)}


def write(rows: dict[tuple[str, str], tuple[int, str]]) -> None:
    with FILE.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows([*key, *value] for key, value in rows.items())


def printed_by(image: str, emulator: list[str]) -> str:
    is_qemu = emulator[0].startswith("qemu-system-")
    command = emulator[:1] + (["-icount", "shift=2"] if is_qemu else []) + emulator[1:] + [image]
    result = subprocess.run(command, capture_output=True, text=True, timeout=300)
    if result.returncode != 0:
        raise ValueError(f"{image} ended with {result.returncode} and printed '{result.stdout}{result.stderr}'")
    return result.stdout


def measured(board: str, text: str, is_qemu: bool) -> dict[tuple[str, str], tuple[int, str]]:
    stages = re.findall(r"^\| ([a-z].*?) \| (\d+) \| \d+\.\d\d \|$", text, re.MULTILINE)
    yardstick = re.search(r"^The yardstick: (\d+) turns of a loop of two instructions in (\d+) cycles$", text, re.MULTILINE)
    if len(stages) != 5 or not yardstick:
        raise ValueError(f"{board} printed no table of five stages and a yardstick, but '{text}'")
    turns, cycles = int(yardstick[1]), int(yardstick[2])
    scale = INSTRUCTIONS_A_TURN * turns / cycles if is_qemu else 1
    rows = {(board, stage): (round(int(count) * scale), "instructions" if is_qemu else "cycles") for stage, count in stages}
    if is_qemu:  # no wire of an emulator's takes time
        rows = {key: row for key, row in rows.items() if key[1] not in ("the bus alone", "a frame")}
    wire = re.search(r"^The bus: (\d+) bits a frame at (\d+) Hz$", text, re.MULTILINE)
    if wire:
        rows[board, "bits on the bus"] = (int(wire[1]), f"{wire[2]} Hz")
    return rows


def complaints(old: dict, new: dict) -> list[str]:
    found = [f"{board} has no '{stage}' in {FILE.name}" for board, stage in new.keys() - old.keys()]
    found += [f"{FILE.name} has '{stage}' of {board}, and bench does not" for board, stage in old.keys() - new.keys()]
    for key in new.keys() & old.keys():
        (now, unit), (then, old_unit) = new[key], old[key]
        if unit != old_unit or abs(now - then) * 100 > TOLERANCE_PERCENT * then:
            found.append(f"'{key[1]}' takes {now} ({unit}) on {key[0]}; expected {then} ({old_unit}) within {TOLERANCE_PERCENT} %")
    return sorted(found)


def main() -> int:
    words = sys.argv[1:]
    bless = words[:1] == ["--bless"]
    board, image, *emulator = words[1:] if bless else words
    new = measured(board, printed_by(image, emulator), emulator[0].startswith("qemu-system-"))
    all_rows = recorded()
    old = {key: row for key, row in all_rows.items() if key[0] == board}
    if bless:
        write(dict(sorted(({key: row for key, row in all_rows.items() if key not in old} | new).items(), key=lambda item: item[0][0])))
        return 0
    wrong = complaints(old, new)
    for sentence in wrong:
        print(f"{sentence}.", file=sys.stderr)
    if wrong:
        print(f"If that is meant, run 'scripts/boards.sh --measure {board}'.", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except ValueError as error:
        print(f"{error}.", file=sys.stderr)
        sys.exit(1)
