"""Counts the images of one board and holds them against the budgets. For CTest.

usage: check_budgets.py <board> <folder of the boards' builds> <instruction_counter.so>
"""
import sys
from pathlib import Path

import budgets
from commands import PROJECT, BenchError
from counting import FrameCount
from image import Image
from plan import budget_rows


def count(board, builds, plugin):
    found = {}
    for row in budget_rows([board]):
        path = row.image(builds)
        if path.exists():  # compare() names the missing
            found[row] = FrameCount(Image(path), plugin, board).instructions
    return found


def main(board, builds, plugin):
    table = budgets.parse((PROJECT / budgets.FILE).read_text())
    of_board = {row: budget for row, budget in table.items() if row.board == board}
    try:
        complaints, notes = budgets.compare(of_board, count(board, Path(builds), plugin))
    except BenchError as error:
        complaints, notes = [str(error)], []
    print("\n".join([*complaints, *notes, f"{len(of_board)} budgets of {board}, {len(complaints)} broken."]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
