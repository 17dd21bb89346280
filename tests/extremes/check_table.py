"""Whether every trap of docs/extremes.md has a promise and a test that exists, and every test of tests/extremes a row.

usage: check_table.py <project>
"""
import re
import sys
from pathlib import Path

COLUMNS = ["trap", "elsewhere", "shade16", "held by"]
LEAST_ROWS = 40
TEST = re.compile(r"^\s*(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", re.MULTILINE)


def defined_tests(project):
    """The names that a row may have: Suite.Name of the C++ tests, compile_fail.<file>, proof.<file>, fuzz.<file>, random_<file>."""
    tests = project / "tests"
    names = {f"{suite}.{name}" for source in tests.rglob("*.[ch]pp") for suite, name in TEST.findall(source.read_text())}
    names |= {f"compile_fail.{source.stem}" for source in (tests / "compile_fail").glob("*.cpp")}
    names |= {f"proof.{source.name.removesuffix('.gappa.in')}" for source in (tests / "proof").glob("*.gappa.in")}
    names |= {f"fuzz.{source.stem.removeprefix('fuzz_')}" for source in (tests / "fuzz").glob("fuzz_*.cpp")}
    names |= {source.stem for source in (tests / "fuzz").glob("random_*.cpp")}
    return names


def extremes_tests(project):
    return {f"{suite}.{name}" for source in (project / "tests/extremes").glob("*_test.cpp") for suite, name in TEST.findall(source.read_text())}


def rows_of(page):
    """The cells of every table row, without the heads."""
    for number, line in enumerate(page.splitlines(), 1):
        if not line.startswith("|"):
            continue
        cells = [cell.strip() for cell in line.strip().strip("|").split(" | ")]
        if set(line) <= set("|- ") or cells == COLUMNS:
            continue
        yield number, cells


def complaints_about(page, defined, must_be_named, least_rows=LEAST_ROWS):
    rows = list(rows_of(page))
    if len(rows) < least_rows:
        yield f"there are {len(rows)} rows, and should be at least {least_rows}"
    seen, named = set(), set()
    for number, cells in rows:
        if len(cells) != len(COLUMNS) or not all(cells):
            yield f"line {number}: a row has {len(COLUMNS)} cells, none of them empty: {', '.join(COLUMNS)}"
            continue
        if cells[0] in seen:
            yield f"line {number}: the trap '{cells[0]}' has a row already"
        seen.add(cells[0])
        tests = re.findall(r"`([^`]+)`", cells[3])
        if not tests:
            yield f"line {number}: no test holds '{cells[0]}'"
        named.update(tests)
        yield from (f"line {number}: there is no test {test}" for test in tests if test not in defined)
    yield from (f"the test {test} is in no row" for test in sorted(must_be_named - named))


def main():
    project = Path(sys.argv[1])
    page = (project / "docs/extremes.md").read_text()
    complaints = list(complaints_about(page, defined_tests(project), extremes_tests(project)))
    for complaint in complaints:
        print(f"docs/extremes.md: {complaint}", file=sys.stderr)
    if not complaints:
        print(f"{len(list(rows_of(page)))} traps, each held by tests that exist")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
