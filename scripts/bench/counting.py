"""Runs an image under QEMU with the counting plugin."""
import re
import shlex
import tempfile
from collections import Counter
from pathlib import Path

from commands import PROJECT, BenchError, run
from image import Frame, Image
from stages import STAGES, stage_of

PLUGIN_SOURCE = PROJECT / "tests/budget/counter/instruction_counter.cpp"
_LONGEST_RUN_SECONDS = 120
_UNKNOWN = (Frame("code without a symbol", ""),)


def build_plugin(folder):
    plugin = folder / "instruction_counter.so"
    folder.mkdir(parents=True, exist_ok=True)
    run(["c++", "-std=c++20", "-O2", "-shared", "-fPIC", "-fvisibility=hidden", PLUGIN_SOURCE, "-o", plugin],
        "The counting plugin does not compile")
    return plugin


def emulator(board):
    """The command that runs an image of this board, from its board.cmake."""
    board_file = PROJECT / "boards" / board / "board.cmake"
    script = PROJECT / "scripts/bench/emulator.cmake"
    command = ["cmake", f"-DBOARD_FILE={board_file}", "-P", script]
    return shlex.split(run(command, f"The emulator of {board} is not known"))


class FrameCount:
    """The instructions of an image's first frame. Those in the `shared` ranges are counted apart for each caller."""

    def __init__(self, image, plugin, board, shared=(), marks=("frame_begin", "frame_end")):
        self.image = image
        self._marks = marks
        self._shared = shared
        text = self._run(plugin, board)
        self.stack_bytes = int(re.match(r"stack (\d+)", text)[1])
        marker = image.extent(marks[0])  # its own instructions are not the frame's
        rows = [line.split() for line in text.splitlines()[1:]]
        self.counts = [(int(a, 16), int(caller, 16), int(n)) for a, caller, n in rows if int(a, 16) not in marker]
        self.instructions = sum(n for _, _, n in self.counts)

    def _run(self, plugin, board):
        image = self.image
        with tempfile.TemporaryDirectory() as folder:
            shared, out = Path(folder, "shared"), Path(folder, "counts")
            shared.write_text("".join(f"{first:x} {end:x}\n" for first, end in self._shared))
            arguments = {"main": image.address("main"), "begin": image.address(self._marks[0]), "end": image.address(self._marks[1]),
                         "stack": image.address("shade16_bss_end"), "stack_end": image.address("shade16_stack_end"),
                         "shared": shared, "out": out}
            options = ",".join(f"{name}={value}" for name, value in arguments.items())
            program, *rest = emulator(board)
            run([program, "-plugin", f"{plugin},{options}", *rest, image.path], f"{image.path} does not run",
                seconds=_LONGEST_RUN_SECONDS)
            if not out.exists():
                raise BenchError(f"{image.path} ended without a call of {self._marks[0]}() and then of {self._marks[1]}().")
            return out.read_text()

    def stages(self):
        """Instructions by stage. Their sum is `instructions`."""
        sums = dict.fromkeys(STAGES, 0)
        for address, caller, count in self.counts:
            sums[self._stage(address) or self._stage(caller) or "transform"] += count
        return sums

    def _stage(self, address):
        return stage_of(self.image.chains.get(address, ()))

    def by_function(self):
        """Instructions by function as the linker knows it."""
        names = {a: name for first, end, name in self.image.functions for a in range(first, end, 2)}
        sums = Counter()
        for address, _, count in self.counts:
            sums[names.get(address, "code without a symbol")] += count
        return sums

    def by_source(self):
        """Instructions by the innermost function of the source, inlined or not."""
        sums = Counter()
        for address, _, count in self.counts:
            sums[self.image.chains.get(address, _UNKNOWN)[0]] += count
        return sums


def shared_ranges(image):
    """Where the code is that has no stage of its own: what FrameCount needs to be asked for stages."""
    ranges = []
    for first, end, _ in image.functions:
        for address in range(first, end, 2):
            if stage_of(image.chains[address]) is not None:
                continue
            if ranges and ranges[-1][1] == address:
                ranges[-1][1] = address + 2
            else:
                ranges.append([address, address + 2])
    return ranges


def measure(path, plugin, board):
    """The columns of one row of the table."""
    image = Image(path)
    frame = FrameCount(image, plugin, board, shared_ranges(image))
    return {"instructions": frame.instructions, **frame.stages(), **image.sizes(), "stack_bytes": frame.stack_bytes}
