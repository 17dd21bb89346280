"""What an image's flash and RAM go to, in a few lines: printed when a board's app is linked.

usage: sizes.py <image> <what stands before the names of its readelf and addr2line>
"""
import re
import sys
from collections import Counter

from commands import BenchError
from image import Image, demangle
from names import short_name
from stages import DRIVERS, STAGES, stage_of

_FOLDERS = (("num", r"num/|glsl"), ("scene", "scene/"), ("target", "target/"), ("runtime", "firmware/runtime/"),
            ("drivers", "firmware/(display|mcu|adapters)/|boards/"), ("app", "|".join(DRIVERS)))


def part_of(chain):
    """A stage of the frame, or whose code it is: that of the first folder that is known, from the inside out."""
    stage = stage_of(tuple(frame for frame in chain if not frame.file.startswith(DRIVERS)))
    if stage:
        return stage
    for frame in chain:
        for part, folder in _FOLDERS:
            if re.match(folder, frame.file):
                return part
    return "compiler's library"


def code(image):
    """Bytes of code by part. What lies in a function and is no instruction, a literal, counts where it lies."""
    sums = Counter()
    for first, end, _ in image.functions:
        for address in range(first, end, 2):
            sums[part_of(image.chains[address])] += min(2, end - address)
    return sums


def constants(image):
    """Bytes of named constants in flash: meshes, and the engine's tables."""
    flash = image.section(".text")
    extents = [(size, name) for address, size, name in image.extents if address in flash]
    names = demangle((name for _, name in extents), image.tools)
    sums = Counter()
    for size, name in extents:
        sums["model" if "assets::" in names[name] or re.search(r"\b(torus|sphere|textured_sphere)\b", names[name]) else
             "tables" if names[name].startswith("shade16::") else "other constants"] += size
    return sums


def variables(image):
    """(bytes, name) of what is in RAM, the largest first."""
    ram = [image.section(".data"), image.section(".bss")]
    extents = [(size, name) for address, size, name in image.extents if any(address in section for section in ram)]
    names = demangle((name for _, name in extents), image.tools)
    return sorted(((size, short_name(names[name])) for size, name in extents), reverse=True)


def listed(pairs):
    return ", ".join(f"{name} {size:,}" for name, size in pairs if size)


def report(image):
    by_part, data = code(image), constants(image)
    flash = image.section_bytes(".text") + image.section_bytes(".data") + image.section_bytes(".boot2")
    named = sum(by_part.values()) + sum(data.values())
    data["strings and padding"] = flash - named
    engine = [(part, by_part.pop(part, 0)) for part in (*STAGES, "num", "scene", "target")]
    ram, (start, end) = variables(image), (image.address(f"shade16_{name}") for name in ("bss_end", "stack_end"))
    used = image.section_bytes(".data") + image.section_bytes(".bss")
    return (f"flash {flash:,} B\n"
            f"  engine {sum(size for _, size in engine):,}: {listed(engine)}\n"
            f"  besides: {listed(sorted([*by_part.items(), *data.items()]))}\n"
            f"RAM {used:,} B: {listed((name, size) for size, name in ram[:4])}; the stack has the other {end - start:,}")


def main(path, tools):
    try:
        print(report(Image(path, tools)))
    except BenchError as error:  # nothing that a build should fail for
        print(f"What the image holds is not known: {error}")


if __name__ == "__main__":
    main(*sys.argv[1:])
