"""tests/budget/budgets.csv: what each scene may cost."""
import csv
import io
from typing import NamedTuple, Optional

from commands import BenchError
from plan import Row

TOLERANCE_PERCENT = 1
FILE = "tests/budget/budgets.csv"
_COLUMNS = ["scene", "board", "tier", "instructions", "limit"]
_BLESS = "'scripts/bench.sh --bless'"


class Budget(NamedTuple):
    instructions: int
    limit: Optional[int]  # None: only the tolerance holds


def parse(text):
    """{Row: Budget} of the file's text."""
    reader = csv.DictReader(io.StringIO(text))
    if reader.fieldnames != _COLUMNS:
        raise BenchError(f"{FILE} begins with the columns {reader.fieldnames}; expected {_COLUMNS}.")
    budgets = {}
    for line in reader:
        row = Row(line["scene"], line["board"], line["tier"])
        if row in budgets:
            raise BenchError(f"{FILE} has two rows for {row}; expected one.")
        budgets[row] = Budget(int(line["instructions"]), int(line["limit"]) if line["limit"] else None)
    return budgets


def write(counts, old):
    """The file's text for today's counts {Row: instructions}; the limits stay those of `old`."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(_COLUMNS)
    for row, instructions in counts.items():
        limit = old[row].limit if row in old else None
        writer.writerow([*row, instructions, "" if limit is None else limit])
    return out.getvalue()


def _judge(row, count, budget):
    """(complaints, notes) about a row that has both a count and a budget."""
    complaints, notes = [], []
    change = 100 * (count - budget.instructions) / budget.instructions
    if budget.limit is not None and count > budget.limit:
        complaints.append(f"{row} takes {count} instructions; its limit is {budget.limit}, which stays: "
                          "make it cheaper.")
    if change > TOLERANCE_PERCENT:
        complaints.append(
            f"{row} takes {count} instructions, {change:.2f} % more than the {budget.instructions} in {FILE}; expected "
            f"at most {TOLERANCE_PERCENT} %: make it cheaper, or run {_BLESS} and say in the commit what it is worth.")
    if change < -TOLERANCE_PERCENT:
        notes.append(f"{row} takes {count} instructions, {-change:.2f} % less than the {budget.instructions} in "
                     f"{FILE}: run {_BLESS}, so that it stays so.")
    return complaints, notes


def compare(budgets, counts):
    """(complaints, notes), a sentence each. Every row must be in both."""
    complaints = [f"{row} is in {FILE} but was not measured: build its image, or remove the row."
                  for row in budgets if row not in counts]
    complaints += [f"{row} has no row in {FILE}: run {_BLESS}." for row in counts if row not in budgets]
    notes = []
    for row in counts.keys() & budgets.keys():
        more_complaints, more_notes = _judge(row, counts[row], budgets[row])
        complaints += more_complaints
        notes += more_notes
    return sorted(complaints), sorted(notes)
