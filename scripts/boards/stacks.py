#!/usr/bin/env python3
"""How much of its stack the turntable uses on each emulated board, which its start-up paints to be able to tell, against tests/budget/stacks.csv.

usage: stacks.py BOARD IMAGE    exit code 1 where the board uses more than is recorded, or where nothing is
       stacks.py --bless BOARD IMAGE    records what it uses today
"""
import re
import shlex
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FILE = ROOT / "tests/budget/stacks.csv"
HEADER = "board,used_bytes,stack_bytes"
sys.path.insert(0, str(ROOT / "scripts/bench"))
from commands import BenchError, run  # noqa: E402


def emulator(board: str) -> list[str]:
    script = ["cmake", f"-DBOARD_FILE={ROOT}/boards/{board}/board.cmake", "-P", ROOT / "scripts/bench/emulator.cmake"]
    return shlex.split(run(script, f"The emulator of {board} is not known"))


def told(command: list[str], word: str) -> list[str]:
    """The command that runs a program and tells it a word."""
    words = []
    for part in command:
        if part == "-semihosting":
            words += ["-semihosting-config", f"enable=on,arg={word}"]
        elif part.endswith(".mjs"):
            words += [part, "--tell", word]
        else:
            words.append(part.replace("chardev=text", f"chardev=text,arg={word}") if part.startswith("enable=on") else part)
    return words


def measured(board: str, image: Path) -> tuple[int, int]:
    """Bytes used, and bytes there are."""
    said = run([*told(emulator(board), "stack"), image], f"{image} does not run", seconds=60)
    match = re.search(r"^stack (\d+) of (\d+) bytes$", said, re.MULTILINE)
    if not match:
        raise BenchError(f"{image} was told 'stack' and does not say how much of it was used.")
    return int(match[1]), int(match[2])


def recorded() -> dict[str, tuple[int, int]]:
    head, *lines = FILE.read_text().splitlines() if FILE.exists() else [HEADER]
    if head != HEADER:
        raise BenchError(f"{FILE.name} begins with '{head}'; expected '{HEADER}'.")
    rows = (line.split(",") for line in lines)
    return {board: (int(used), int(there)) for board, used, there in rows}


def complaint(board: str, used: int, there: int, record: dict[str, tuple[int, int]]) -> str:
    """A sentence, or nothing."""
    bless = f"run 'scripts/boards.sh --measure {board}'"
    if used >= there:
        return f"The turntable uses {used} bytes of stack on {board}, which has {there}."
    if board not in record:
        return f"{board} has no row in tests/budget/stacks.csv: {bless}."
    if used > record[board][0]:
        return (f"The turntable uses {used} bytes of stack on {board}, and {record[board][0]} are recorded in tests/budget/stacks.csv: "
                f"use less, or {bless} and say in the commit what it is worth.")
    if there != record[board][1]:
        return f"{board} has a stack of {there} bytes, and {record[board][1]} are recorded in tests/budget/stacks.csv: {bless}."
    return ""


def bless(board: str, used: int, there: int) -> None:
    rows = sorted((recorded() | {board: (used, there)}).items())
    FILE.write_text("\n".join([HEADER] + [f"{name},{u},{t}" for name, (u, t) in rows]) + "\n")


def main() -> int:
    words = sys.argv[1:]
    blesses = words[:1] == ["--bless"]
    try:
        board, image = words[1:] if blesses else words
        used, there = measured(board, Path(image))
        if blesses:
            bless(board, used, there)
        sentence = complaint(board, used, there, recorded())
    except BenchError as error:
        sentence = str(error)
    print(sentence or f"{board} uses {used} of {there} bytes of its stack.", file=sys.stderr if sentence else sys.stdout)
    return 1 if sentence else 0


if __name__ == "__main__":
    sys.exit(main())
