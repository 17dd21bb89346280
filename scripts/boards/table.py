#!/usr/bin/env python3
"""The table of boards in docs/boards.md: of each board.cmake and board.hpp.

usage: table.py          exit code 1 where the page has another table
       table.py --write  writes it
"""
import re
import sys
from math import prod
from pathlib import Path

from page import ROOT, keep_table


def cmake_value(text: str, name: str) -> str:
    match = re.search(rf"set\({name}\s+([^)]*)\)", text)
    return " ".join(match.group(1).split()).strip('"') if match else ""


def number(header: Path, name: str) -> int:
    """A constant of struct Board, of the header that it inherits from, or of its chip."""
    if not header.exists():
        raise ValueError(f"There is no {header}; docs/boards.md, step 1, has one to copy.")
    text = header.read_text()
    chip = re.search(rf"\b{name} = (\w+)::{name};", text)
    if chip:
        return number(ROOT / "firmware" / "mcu" / chip.group(1) / "chip.hpp", name)
    match = re.search(rf"\b{name} = ([\d' *-]+)[;,]", text)
    if match:
        less = [[int(factor) for factor in product.split("*")] for product in match.group(1).replace("'", "").split("-")]
        first, *rest = [prod(factors) for factors in less]
        return first - sum(rest)
    base = re.search(r"struct Board : (\w+)", text)
    if not base:
        raise ValueError(f"{header} says no {name} in decimal numbers; expected one such as 128 * 1024.")
    return number(ROOT / "boards" / f"{base.group(1).lower()}.hpp", name)


def memory(size: int) -> str:
    return f"{size / 2**20:.0f} MB" if size >= 1_000_000 else f"{size >> 10} KB"


def tested(cmake: str) -> str:
    emulator = cmake_value(cmake, "BOARD_EMULATOR").split()
    if not emulator:
        return "built"
    what = "frames" if "BOARD_TOO_SMALL_FOR_IDENTITY" in cmake else "frames and hashes"
    if emulator[0] != "${PICO_EMULATOR}" and "-M" not in emulator:
        raise ValueError(f"BOARD_EMULATOR '{' '.join(emulator)}' names no machine; expected -M and its name.")
    where = "rp2040js" if emulator[0] == "${PICO_EMULATOR}" else f"{emulator[0]} (`-M {emulator[emulator.index('-M') + 1]}`)"
    if "BOARD_EMULATED_CONSOLE" in cmake:
        return f"{what} in {where}, every pixel of strict models of the chip and the panel"
    shown = ", every pixel of a strict model of the panel" if "BOARD_SCREEN_MODEL" in cmake else ", every pixel of the screen"
    return f"{what} in {where}" + (shown if "BOARD_SCREEN_BITS" in cmake else "")


def stack(board: str) -> str:
    """What the turntable used of its stack when scripts/boards.sh --measure looked."""
    row = re.search(rf"^{board},(\d+),(\d+)$", (ROOT / "tests/budget/stacks.csv").read_text(), re.MULTILINE)
    return f"{int(row[1]):,} of {int(row[2]):,} B" if row else "not measured"


def rows() -> list[str]:
    lines = ["| board | core | clock | flash | RAM | stack used | display | tested |", "|---|---|---|---|---|---|---|---|"]
    for file in sorted((ROOT / "boards").glob("*/board.cmake")):
        cmake, header = file.read_text(), file.parent / "board.hpp"
        cells = [f"`{file.parent.name}`", cmake_value(cmake, "BOARD_CORE"), f"{number(header, 'cpu_hz') // 1_000_000} MHz",
                 memory(number(header, "flash_bytes")), memory(number(header, "ram_bytes")), stack(file.parent.name), cmake_value(cmake, "BOARD_DISPLAY"), tested(cmake)]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


if __name__ == "__main__":
    try:
        sys.exit(keep_table("boards", rows()))
    except ValueError as error:
        sys.exit(str(error))
