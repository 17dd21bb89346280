#!/usr/bin/env python3
"""The panels' headers in firmware/display: of the texts in boards/panels, whose format docs/panels.md has.

usage: panels.py          exit code 1 where a header is not what the texts say
       panels.py --write  writes the headers
"""
import sys
from dataclasses import dataclass, field
from pathlib import Path

from page import ROOT

PANELS = ROOT / "boards" / "panels"
HEADERS = ROOT / "firmware" / "display"
NO_OPERATION, NORMAL_MODE, NOT_INVERTED, INVERTED, DISPLAY_ON, ACCESS, PIXEL_FORMAT = 0x00, 0x13, 0x20, 0x21, 0x29, 0x36, 0x3A
STEP_MS, MOST_STEPS = 5, 255
WIDEST = 140
FORMS = {"command": (1, 128, 255), "delay": (1, 1, 255), "glass": (2, 2, 2048), "memory": (2, 2, 65535), "offset": (2, 2, 65535)}


@dataclass
class Panel:
    name: str
    intro: list[str] = field(default_factory=list)  # the comments at the file's top
    base: str = ""
    commands: list[list[int]] = field(default_factory=list)
    waits_ms: list[int] = field(default_factory=list)  # after each command
    pairs: dict[str, list[int]] = field(default_factory=dict)
    access: int = 0
    inverted: bool = False

    @property
    def controller(self) -> str:
        return self.name.split("_")[0]

    def add(self, command: list[int]) -> None:
        self.commands.append(command)
        self.waits_ms.append(0)

    def wait(self, ms: int) -> None:
        if not self.commands:
            self.add([NO_OPERATION])
        self.waits_ms[-1] += ms


def take_command(panel: Panel, numbers: list[int]) -> None:
    """The drivers send some commands by themselves: those are facts, the rest is the beginning."""
    code, *parameters = numbers
    if code == NO_OPERATION and len(parameters) == 1:  # how the kernel's driver stores a delay
        panel.wait(parameters[0])
    elif code == ACCESS:
        panel.access, = parameters
    elif code in (INVERTED, NOT_INVERTED):
        panel.inverted = code == INVERTED
    elif code not in (PIXEL_FORMAT, NORMAL_MODE, DISPLAY_ON):
        panel.add(numbers)


class Mistake(Exception):
    """A sentence about a text."""


def numbers_of(words: list[str]) -> list[int]:
    if words[0] not in FORMS:
        raise Mistake(f"unknown word '{words[0]}'; expected one of {', '.join(FORMS)}, or 'as' before all others.")
    least, most, largest = FORMS[words[0]]
    try:
        numbers = [int(number, 0) for number in words[1:]]
    except ValueError as error:
        raise Mistake(f"'{' '.join(words)}' has what is no number; expected some such as 120 or 0x78.") from error
    if not least <= len(numbers) <= most or any(not 0 <= number <= largest for number in numbers):
        raise Mistake(f"'{' '.join(words)}' does not fit; expected {least if least == most else f'{least} to {most}'} numbers of 0 to {largest}.")
    return numbers


def take_words(panel: Panel, words: list[str]) -> None:
    numbers = numbers_of(words)
    if words[0] == "command":
        take_command(panel, numbers)
    elif words[0] == "delay":
        panel.wait(numbers[0])
    else:
        panel.pairs[words[0]] = numbers


def take(panel: Panel, file: Path) -> None:
    """What comes later holds. The tests read every text with panel_file.cpp, too, which minds more."""
    for number, line in enumerate(file.read_text().splitlines(), 1):
        said, _, comment = line.partition("#")
        for words in said.split(), comment[1:].split() if comment.startswith(":") else []:
            if words and words[0] != "as":
                try:
                    take_words(panel, words)
                except Mistake as mistake:
                    raise Mistake(f"{file}, line {number}: {mistake}") from mistake


def read_panel(file: Path) -> Panel:
    panel, text = Panel(file.stem), file.read_text()
    for line in text.splitlines():
        if not line.startswith("# "):
            break
        panel.intro.append(line[2:])
    bases = [line.split()[2] for line in text.splitlines() if line.startswith("#: as ")]
    if bases:
        panel.base = bases[0]
        base = file.parent / f"{panel.base}.txt"
        if not base.exists():
            raise Mistake(f"{file}: stands on '{panel.base}'; expected {base} to be there.")
        take(panel, base)
    take(panel, file)
    if "glass" not in panel.pairs:
        raise Mistake(f"{file}: does not say how large the glass is; expected a line such as '#: glass 240 320'.")
    return panel


def beginning(panel: Panel) -> list[str]:
    """One row a command: its byte, the number of its parameters, they, and how often to wait 5 ms."""
    rows = []
    for (code, *parameters), wait_ms in zip(panel.commands, panel.waits_ms):
        steps = -(-wait_ms // STEP_MS)
        shape = [str(len(parameters))] * (not steps or len(parameters) > 0) + ["then_wait"] * (steps > 0)
        row = [f"0x{code:02X}", " | ".join(shape)] + [f"0x{byte:02X}" for byte in parameters]
        while steps > MOST_STEPS:
            rows.append(", ".join(row + [str(MOST_STEPS)]) + ",")
            row, steps = ["0x00", "then_wait"], steps - MOST_STEPS
        rows.append(", ".join(row + [str(steps)] * (steps > 0)) + ",")
    return rows


def wrapped(items: list[str]) -> list[str]:
    lines = [""]
    for item in items:
        if len(lines[-1]) + len(item) + 6 > WIDEST:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "    ") + item + ","
    return lines


def members(panel: Panel, array: str) -> list[str]:
    width, height = panel.pairs["glass"]
    memory_width, memory_height = panel.pairs.get("memory", [width, height])
    x, y = panel.pairs.get("offset", [0, 0])
    columns_mirrored, rows_mirrored, blue_first = (bool(panel.access & bit) for bit in (0x40, 0x80, 0x08))
    # The text has the offset of the upright picture; a DcsPanel, that from the end where memory begins.
    first = {"first_column": memory_width - width - x if columns_mirrored else x, "first_row": memory_height - height - y if rows_mirrored else y}
    flags = {"columns_mirrored": columns_mirrored, "rows_mirrored": rows_mirrored, "blue_first": blue_first, "inverted": panel.inverted}
    return wrapped([f'.name = "{panel.name}"', f".width_px = {width}", f".height_px = {height}",
                    f".memory_width_px = {memory_width}", f".memory_height_px = {memory_height}"]
                   + [f".{name} = {value}" for name, value in first.items() if value]
                   + [f".{name} = true" for name, value in flags.items() if value]
                   + [f".beginning = {array}", f".beginning_bytes = sizeof({array})"])


def header(panels: list[Panel]) -> str:
    """A controller's: its own panel first, then those that stand on it. A list that several have stands there once."""
    first = next((panel for panel in panels if not panel.base), None)
    if first is None:
        raise Mistake(f"{PANELS}/{panels[0].name}.txt: there is no panel of a {panels[0].controller} with a list of its own; expected one without '#: as'.")
    texts = f"{first.controller}*.txt" if len(panels) > 1 else f"{first.name}.txt"
    out = [f"// {line}" for line in first.intro]
    out += [f"// Made by scripts/boards.sh of boards/panels/{texts}, which says what the commands do.", "#pragma once", "",
            "#include <display/dcs.hpp>", "", "namespace shade16 {"]
    arrays: dict[str, str] = {}
    for panel in [first] + [other for other in panels if other is not first]:
        rows = "\n".join("    " + row for row in beginning(panel))
        if rows not in arrays:
            arrays[rows] = f"{panel.name if arrays else panel.controller}_beginning"
            out += ["", f"inline constexpr uint8_t {arrays[rows]}[] = {{", rows, "};"]
        out += [""] + [f"// {line}" for line in (panel.intro if panel.base else [])]
        out += [f"inline constexpr DcsPanel {panel.name}{{"] + members(panel, arrays[rows]) + ["};"]
    return "\n".join(out + ["", "}  // namespace shade16", ""])


def headers(folder: Path) -> dict[str, str]:
    controllers: dict[str, list[Panel]] = {}
    for file in sorted(folder.glob("*.txt")):
        panel = read_panel(file)
        controllers.setdefault(panel.controller, []).append(panel)
    return {f"{name}.hpp": header(panels) for name, panels in controllers.items()}


def main() -> int:
    made = headers(PANELS)
    if sys.argv[1:] == ["--write"]:
        for name, text in made.items():
            (HEADERS / name).write_text(text)
        return 0
    stale = [name for name, text in made.items() if not (HEADERS / name).exists() or (HEADERS / name).read_text() != text]
    if stale or not made:
        print(f"firmware/display has headers that are not what boards/panels says: {', '.join(stale) or 'there is no panel'}; "
              "run 'scripts/boards.sh'.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Mistake as mistake:
        sys.exit(str(mistake))
