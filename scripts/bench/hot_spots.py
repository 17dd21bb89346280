"""Where a frame's instructions go, for whoever makes it faster."""
from image import demangle
from names import short_name

_LINE_WIDTH, _LEAST_PERCENT = 120, 0.1


def _lines(title, counts, total, least_percent=_LEAST_PERCENT):
    falling = sorted(counts.items(), key=lambda item: -item[1])
    shown = [(name, n) for name, n in falling if 100 * n >= least_percent * total]
    rest = total - sum(n for _, n in shown)
    if rest:
        shown.append((f"below {least_percent} % each", rest))
    return [title] + [f"{n:>12,} {100 * n / total:5.1f} %  {name}"[:_LINE_WIDTH] for name, n in shown]


def _summed(pairs):
    """{name: count}, where several functions may shorten to one name."""
    sums = {}
    for name, n in pairs:
        sums[name] = sums.get(name, 0) + n
    return sums


def report(row, frame):
    """Three tables: stages, functions of the image, and the functions of the source that were inlined into them."""
    functions = frame.by_function()
    full_names = demangle(functions)
    linked = _summed((short_name(full_names[name]), n) for name, n in functions.items())
    sources = _summed((f"{place.file}: {short_name(place.function)}", n) for place, n in frame.by_source().items())
    total = frame.instructions
    return "\n".join([f"{row}: {total:,} instructions in the first frame", "",
                      *_lines("by stage", frame.stages(), total, least_percent=0), "",
                      *_lines("by function, what was inlined included", linked, total), "",
                      *_lines("by the function of the source, inlined or not", sources, total)])
