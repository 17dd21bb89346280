#!/usr/bin/env python3
"""The tables of docs/bounds.md are those that `shade16 report bounds` writes today.

usage: page_tables.py PAGE TABLES            the test: differing tables are stale
       page_tables.py PAGE TABLES --write    puts them into the page
"""
import pathlib
import sys

BEGIN, END = "<!-- measured: scripts/bounds.sh -->\n", "<!-- end -->\n"


def main(page, tables, write=""):
    page = pathlib.Path(page)
    before, _, rest = page.read_text().partition(BEGIN)
    committed, _, after = rest.partition(END)
    if not rest or END not in rest:
        print(f"{page}: has no place for the tables; expected the lines {BEGIN.strip()} and {END.strip()}.")
        return 1
    measured = pathlib.Path(tables).read_text()
    if write == "--write":
        page.write_text(before + BEGIN + "\n" + measured + "\n" + END + after)
        return 0
    was, now = committed.strip().splitlines(), measured.strip().splitlines()
    stale = [f"  was {old}\n  is  {new}" for old, new in zip(was, now) if old != new]
    if len(was) != len(now):
        stale.append(f"  {len(was)} lines in the page, {len(now)} measured")
    print("\n".join([f"{page} is stale: run scripts/bounds.sh, and look at what changed.", *stale[:20]]) if stale else f"{page} is what was measured.")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
