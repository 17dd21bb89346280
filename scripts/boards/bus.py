#!/usr/bin/env python3
"""The table of buses in docs/boards.md: what a frame is on each panel's wire, how long that and drawing take, and which of the two limits.
Of tests/budget/cycles.csv and the boards' clocks.

usage: bus.py          exit code 1 where the page has another table
       bus.py --write  writes it
"""
import sys

from bench import recorded
from page import ROOT, keep_table
from table import cmake_value, number

DRAWING = ("vertices: transform and light", "set-up of the frame", "background", "triangles", "triangles and their vertices")


def row(board: str, stages: dict[str, tuple[int, str]]) -> str:
    folder = ROOT / "boards" / board
    bits, clock = stages["bits on the bus"]
    hz = int(clock.removesuffix(" Hz"))
    drawing = sum(count for stage, (count, _) in stages.items() if stage in DRAWING)
    unit = stages["background"][1]
    bus_ms = 1000 * bits / hz
    drawing_ms = 1000 * drawing / number(folder / "board.hpp", "cpu_hz")
    together = f"{1000 * stages['a frame'][0] / number(folder / 'board.hpp', 'cpu_hz'):.1f} ms" if "a frame" in stages else ""
    display = cmake_value((folder / "board.cmake").read_text(), "BOARD_DISPLAY").split(",")[0]
    cells = [f"`{board}`", display, f"{bits // 8}", f"{hz / 1e6:.4g} MHz", f"{bus_ms:.1f} ms", f"{drawing / 1e6:.2f} M {unit}",
             f"{drawing_ms:.1f} ms", together, "the bus" if bus_ms > drawing_ms else "drawing"]
    return "| " + " | ".join(cells) + " |"


def rows() -> list[str]:
    boards = {}
    for (board, stage), value in recorded().items():
        boards.setdefault(board, {})[stage] = value
    lines = ["| board | panel | bytes a frame | bus | bus alone | drawing | drawing alone | measured together | limit |", "|---|---|---|---|---|---|---|---|---|"]
    return lines + [row(board, stages) for board, stages in sorted(boards.items()) if "bits on the bus" in stages]


if __name__ == "__main__":
    sys.exit(keep_table("bus", rows()))
