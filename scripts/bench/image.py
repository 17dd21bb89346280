"""What an image holds: its symbols, its sections, and for each address the functions that were inlined there."""
import re
from functools import cached_property
from typing import NamedTuple

from commands import BenchError, run

TOOLS = "arm-none-eabi-"


class Frame(NamedTuple):
    """One function of an inline chain. `file` counts from the project's top folder or from core/include/shade16."""
    function: str
    file: str


def _run(tool, *arguments, text=None, tools=TOOLS):
    return run([tools + tool, *arguments], "An image cannot be read", text)


def short_path(path):
    """A path as the project knows it: the folders that a build stands in mean nothing to the reader."""
    match = re.fullmatch(r".*/(?:core/include/shade16/|(?=(?:firmware|boards|tests|assets)/))(.*)", path)
    return match[1] if match else path.rsplit("/", 1)[-1]


class Image:
    def __init__(self, path, tools=TOOLS):
        self.path = str(path)
        self.tools = tools  # what stands before the names of another processor's programs

    def _run(self, tool, *arguments, text=None):
        return _run(tool, *arguments, text=text, tools=self.tools)

    @cached_property
    def _symbols(self):
        """(name, address, bytes, type) of every symbol; a Thumb function's lowest bit is not part of its address."""
        rows = (line.split() for line in self._run("readelf", "--symbols", "--wide", self.path).splitlines())
        symbols = [row for row in rows if len(row) == 8 and row[0][:-1].isdigit()]
        return [(name, int(value, 16) & (~1 if kind == "FUNC" else ~0), int(size, 0), kind)
                for _, value, size, kind, _, _, _, name in symbols]

    def address(self, name):
        for symbol, address, _, _ in self._symbols:
            if symbol == name:
                return address
        raise BenchError(f"{self.path} has no symbol '{name}'.")

    def extent(self, function):
        """The addresses of a function's code, as a range."""
        first = self.address(function)
        return range(first, first + max(size for _, address, size, _ in self._symbols if address == first))

    @cached_property
    def functions(self):
        """(first, end, name), sorted; where several names share an address, the longest extent and one of its names."""
        by_address = {}
        for name, address, size, kind in self._symbols:
            if kind == "FUNC" and size > by_address.get(address, (0,))[0]:
                by_address[address] = (size, name)
        return [(first, first + size, name) for first, (size, name) in sorted(by_address.items())]

    @cached_property
    def objects(self):
        """The mangled names of what is no code: tables, meshes, variables."""
        return sorted({name for name, _, size, kind in self._symbols if kind == "OBJECT" and size > 0})

    @cached_property
    def extents(self):
        """(address, bytes, mangled name) of what is no code, once an address."""
        return [(address, size, name) for address, (size, name) in
                sorted({address: (size, name) for name, address, size, kind in self._symbols if kind == "OBJECT" and size > 0}.items())]

    def section(self, name):
        """The addresses of a section, as a range."""
        listed = self._run("readelf", "--sections", "--wide", self.path)
        match = re.search(rf"\] {re.escape(name)} +\S+ +([0-9a-f]+) +\S+ +([0-9a-f]+) ", listed)
        return range(int(match[1], 16), int(match[1], 16) + int(match[2], 16)) if match else range(0)

    def section_bytes(self, name):
        listed = self._run("readelf", "--sections", "--wide", self.path)
        match = re.search(rf"\] {re.escape(name)} +\S+ +\S+ +\S+ +([0-9a-f]+) ", listed)
        return int(match[1], 16) if match else 0

    def sizes(self):
        """Functions with their literals; what else is in flash; variables, of which frame and depth are the most."""
        text = sum(end - first for first, end, _ in self.functions)
        data = self.section_bytes(".data")
        return {"text_bytes": text, "rodata_bytes": self.section_bytes(".text") + data - text,
                "ram_bytes": data + self.section_bytes(".bss")}

    @cached_property
    def chains(self):
        """Address -> its inline chain, innermost function first, for every halfword of code."""
        addresses = [a for first, end, _ in self.functions for a in range(first, end, 2)]
        text = self._run("addr2line", "--exe", self.path, "--addresses", "--inlines", "--functions", "--demangle",
                    text="".join(f"{a:#x}\n" for a in addresses))
        chains, lines = {}, iter(text.splitlines())
        for line in lines:
            if line.startswith("0x"):
                chain = chains[int(line, 16)] = []
            else:
                chain.append(Frame(line, short_path(next(lines).rsplit(":", 1)[0])))
        return chains


def demangle(names, tools=TOOLS):
    """{mangled: demangled}"""
    names = list(names)
    return dict(zip(names, _run("c++filt", tools=tools, text="\n".join(names)).splitlines()))
