"""The results as text: aligned for the terminal, Markdown for docs/performance.md."""
from commands import BenchError
from plan import BOARDS, DEFAULT_BOARD, DEFAULT_TIER, SCENES, TIERS
from stages import STAGES

COLUMNS = ("instructions", *STAGES, "text_bytes", "rodata_bytes", "ram_bytes", "stack_bytes")
_BEGIN, _END = "<!-- {}: written by scripts/bench.sh --update -->", "<!-- end of {} -->"


def _grouped(number):
    return f"{number:,}"


def _cells(results):
    header = ["scene", "board", "tier", *(name.removesuffix("_bytes") for name in COLUMNS)]
    return [header] + [[*row, *(_grouped(values[name]) for name in COLUMNS)] for row, values in results.items()]


def terminal(results):
    lines = _cells(results)
    widths = [max(map(len, column)) for column in zip(*lines)]
    def aligned(line):
        return [cell.ljust(w) if i < 3 else cell.rjust(w) for i, (cell, w) in enumerate(zip(line, widths))]
    return "\n".join("  ".join(aligned(line)).rstrip() for line in lines)


def _markdown(header, lines, left_columns):
    marks = ["---"] * left_columns + ["--:"] * (len(header) - left_columns)
    return "\n".join("| " + " | ".join(line) + " |" for line in [header, marks, *lines])


def boards_table(results):
    header, *lines = _cells({row: v for row, v in results.items() if row.tier == DEFAULT_TIER})
    return _markdown([header[0], header[1], *header[3:]], [[line[0], line[1], *line[3:]] for line in lines], 2)


def tiers_table(results):
    of = {(row.scene, row.tier): values for row, values in results.items() if row.board == DEFAULT_BOARD}
    lines = []
    for scene in SCENES:
        base = of[scene, DEFAULT_TIER]["instructions"]
        counts = [of[scene, tier]["instructions"] for tier in TIERS]
        sizes = [of[scene, tier]["text_bytes"] + of[scene, tier]["rodata_bytes"] for tier in TIERS]
        lines.append([scene, *(f"{_grouped(n)} ({100 * n / base:.0f} %)" for n in counts), *map(_grouped, sizes)])
    return _markdown(["scene", *TIERS, *(f"{tier}: flash" for tier in TIERS)], lines, 1)


def update_document(text, results):
    """The document with today's tables between their markers."""
    for name, table in (("boards", boards_table(results)), ("tiers", tiers_table(results))):
        begin, end = _BEGIN.format(name), _END.format(name)
        before, found_begin, rest = text.partition(begin)
        _, found_end, after = rest.partition(end)
        if not found_begin or not found_end:
            raise BenchError(f"docs/performance.md lacks the line '{begin}' or '{end}' after it.")
        text = f"{before}{begin}\n\n{table}\n\n{end}{after}"
    return text


def in_order(results):
    """By board, then scene, then tier: how the tables and bench.json are sorted."""
    key = lambda row: (BOARDS.index(row.board), SCENES.index(row.scene), TIERS.index(row.tier))
    return {row: results[row] for row in sorted(results, key=key)}
