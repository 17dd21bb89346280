"""Counts the instructions of the benchmark scenes on the emulated boards. Run it as scripts/bench.sh."""
import argparse
import json
import os
import signal
import sys

import budgets
import glsl_cost
import tables
import term_costs
from commands import PROJECT, BenchError, run
from counting import FrameCount, build_plugin, measure, shared_ranges
from hot_spots import report
from image import Image
from plan import BOARDS, DEFAULT_BOARD, DEFAULT_TIER, SCENES, TIERS, Row, budget_rows, tier_rows

BUILDS = PROJECT / "build"
RESULT = PROJECT / "out/bench.json"
DOCUMENT = PROJECT / "docs/performance.md"


class OneSentenceParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"scripts/bench.sh: {message}; see scripts/bench.sh --help.\n")


def arguments():
    parser = OneSentenceParser(
        prog="scripts/bench.sh", allow_abbrev=False,
        description="Counts the instructions of one frame of the scenes S1 to S6 under QEMU: on all boards in mediump, "
                    "and on the Cortex-M3 in all tiers. Prints a table and writes out/bench.json.")
    parser.add_argument("--update", action="store_true", help="also rewrite the tables in docs/performance.md")
    parser.add_argument("--bless", action="store_true",
                        help="also accept today's counts as tests/budget/budgets.csv; limits stay")
    parser.add_argument("--profile", metavar="SCENE", choices=SCENES,
                        help="instead, print where the instructions of one scene go, S1 to S6")
    parser.add_argument("--glsl", action="store_true",
                        help="instead, print what a call of GLSL's functions costs: the table of docs/glsl.md")
    parser.add_argument("--terms", action="store_true",
                        help="instead, print what each term adds to a scene: the table of docs/performance.md")
    parser.add_argument("--board", choices=BOARDS, help=f"with --profile: the board ({DEFAULT_BOARD})")
    parser.add_argument("--tier", choices=TIERS, help=f"with --profile: the precision tier ({DEFAULT_TIER})")
    given = parser.parse_args()
    if given.profile and (given.update or given.bless):
        parser.error("--profile measures one scene, so that --update and --bless cannot be given with it")
    if given.terms and (given.update or given.bless or given.profile or given.glsl):
        parser.error("--terms measures scenes of its own, so that --update, --bless, --profile and --glsl cannot be given with it")
    if given.glsl and (given.update or given.bless or given.profile):
        parser.error("--glsl measures functions, so that --update, --bless and --profile cannot be given with it")
    if not given.profile and (given.board or given.tier):
        parser.error("--board and --tier choose what --profile looks at, and it was not given")
    return given


def build(rows):
    for board in BOARDS:
        targets = [row.target for row in rows if row.board == board]
        if targets:
            print(f"building {' '.join(targets)} for {board}", file=sys.stderr)
            run(["cmake", "--preset", board], f"{board} cannot be configured")
            run(["cmake", "--build", "--preset", board, "--target", *targets], f"{board} cannot be built")


def replace_file(path, text):
    """Whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(path.name + ".new")
    temporary.write_text(text)
    os.replace(temporary, path)


def as_json(results):
    compiler = run(["arm-none-eabi-g++", "--version"], "The compiler does not run").splitlines()[0]
    rows = [{**row._asdict(), **values} for row, values in results.items()]
    lines = ",\n".join("  " + json.dumps(row) for row in rows)
    return f'{{"compiler": {json.dumps(compiler)}, "rows": [\n{lines}\n]}}\n'


def hold_against_budgets(results, accept):
    """Says what is above or below its budget, which is for CTest to judge; or accepts it."""
    path = PROJECT / budgets.FILE
    recorded = budgets.parse(path.read_text())
    counts = {row: results[row]["instructions"] for row in budget_rows()}
    if accept:
        replace_file(path, budgets.write(counts, recorded))
        recorded = budgets.parse(path.read_text())
    complaints, notes = budgets.compare(recorded, counts)
    print("\n".join(["", *complaints, *notes, f"{len(recorded)} budgets, {len(complaints)} broken."]))


def measure_all(given, plugin):
    rows = budget_rows() + tier_rows()
    build(rows)
    results = tables.in_order({row: measure(row.image(BUILDS), plugin, row.board) for row in rows})
    print(tables.terminal(results))
    replace_file(RESULT, as_json(results))
    if given.update:
        replace_file(DOCUMENT, tables.update_document(DOCUMENT.read_text(), results))
    hold_against_budgets(results, accept=given.bless)


def profile(given, plugin):
    row = Row(given.profile, given.board or DEFAULT_BOARD, given.tier or DEFAULT_TIER)
    build([row])
    image = Image(row.image(BUILDS))
    print(report(row, FrameCount(image, plugin, row.board, shared_ranges(image))))


def main():
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # '| head' ends it quietly
    given = arguments()
    try:
        run(["scripts/setup.sh"], "A package is missing and cannot be installed")
        plugin = build_plugin(BUILDS / "bench")
        if given.profile:
            profile(given, plugin)
        elif given.terms:
            print(term_costs.table(plugin))
        elif given.glsl:
            print(glsl_cost.table(plugin))
        else:
            measure_all(given, plugin)
    except BenchError as error:
        sys.exit(f"scripts/bench.sh: {error}")


if __name__ == "__main__":
    main()
