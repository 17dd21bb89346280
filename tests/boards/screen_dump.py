#!/usr/bin/env python3
"""What an emulated board's display shows at the end of an app, against the last frame that the same app draws on this computer.

Every pixel must be the same code. Emulators widen codes to eight bits in ways of their own, and some show a pixel as a block; the first
bits of each channel are the code in all of them.
"""
import argparse
import json
import os
import socket
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

PATIENCE_S = 60


class Picture:
    """Rows of pixels, three bytes each."""

    def __init__(self, width: int, height: int, rgb: bytes):
        self.width, self.height, self.rgb = width, height, rgb
        if len(rgb) != 3 * width * height:
            raise ValueError(f"{len(rgb)} bytes are no picture of {width}x{height}")

    @staticmethod
    def of_ppm(file: Path) -> "Picture":
        kind, width, height, most, rgb = split_ppm(file.read_bytes())
        if (kind, most) != (b"P6", 255):
            raise ValueError(f"{file} is no PPM of eight bits a channel")
        return Picture(width, height, rgb)

    @staticmethod
    def of_png(file: Path) -> "Picture":
        """One that `png` made: no row is filtered."""
        data = file.read_bytes()
        width, height = struct.unpack(">II", data[16:24])
        at = data.index(b"IDAT")
        length = struct.unpack(">I", data[at - 4:at])[0]
        rows = zlib.decompress(data[at + 4:at + 4 + length])
        stride = 3 * width + 1
        return Picture(width, height, b"".join(rows[y * stride + 1:(y + 1) * stride] for y in range(height)))

    def pixel(self, x: int, y: int) -> bytes:
        at = 3 * (y * self.width + x)
        return self.rgb[at:at + 3]

    def every(self, block: int) -> "Picture":
        """One pixel for each block of block x block equal ones."""
        kept = []
        for y in range(self.height):
            for x in range(self.width):
                pixel = self.pixel(x, y)
                if x % block == 0 and y % block == 0:
                    kept.append(pixel)
                elif pixel != self.pixel(x - x % block, y - y % block):
                    raise ValueError(f"the block of {block}x{block} at {x}, {y} is not of one colour")
        return Picture(self.width // block, self.height // block, b"".join(kept))

    def png(self) -> bytes:
        def chunk(name: bytes, body: bytes) -> bytes:
            return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        rows = b"".join(b"\0" + self.rgb[y * 3 * self.width:(y + 1) * 3 * self.width] for y in range(self.height))
        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def split_ppm(data: bytes) -> tuple[bytes, int, int, int, bytes]:
    words, at = [], 0
    while len(words) < 4:
        end = at
        while not data[end:end + 1].isspace():
            end += 1
        words.append(data[at:end])
        at = end + 1
    return words[0], int(words[1]), int(words[2]), int(words[3]), data[at:]


class Emulator:
    """A machine that holds its last picture, and its monitor."""

    def __init__(self, command: list[str], folder: Path):
        told = [word.replace("chardev=text", "chardev=text,arg=hold") for word in command]
        monitor = folder / "monitor"
        # The image follows the last word, which is -kernel.
        self.process = subprocess.Popen(told[:1] + ["-qmp", f"unix:{monitor},server=on,wait=off"] + told[1:],
                                        stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL, text=True)
        self.printed = ""
        self._wait_until_it_holds()
        self._socket = socket.socket(socket.AF_UNIX)
        self._socket.settimeout(PATIENCE_S)
        self._socket.connect(str(monitor))
        self._replies = self._socket.makefile("r")
        self._replies.readline()
        self.say("qmp_capabilities")

    def _wait_until_it_holds(self) -> None:
        for line in self.process.stdout:
            if line.strip() == "holding":
                return
            self.printed += line
        raise ValueError(f"the machine ended with {self.process.wait()} instead of holding its picture; it printed:\n{self.printed}")

    def say(self, command: str, **arguments) -> None:
        self._socket.sendall((json.dumps({"execute": command, "arguments": arguments}) + "\n").encode())
        while True:
            reply = json.loads(self._replies.readline())
            if "error" in reply:
                raise ValueError(f"{command}: {reply['error']['desc']}")
            if "return" in reply:
                return

    def screen(self, file: Path) -> Picture:
        for _ in range(2):  # the first may be from before the last refresh
            self.say("screendump", filename=str(file))
        return Picture.of_ppm(file)

    def end(self) -> None:
        self.process.kill()
        self.process.wait()


def decoded(options: argparse.Namespace, folder: Path) -> Picture:
    """What the model of the panel shows after all that the board's bus carried."""
    log, picture = folder / "log", folder / "seen.ppm"
    subprocess.run(options.emulator + ["--log", str(log), options.image], check=True, stdout=subprocess.DEVNULL)
    decoder, panel, turns = options.model
    result = subprocess.run([decoder, panel, turns, str(log), str(picture)], capture_output=True, text=True)
    if result.returncode != 0:
        raise ValueError(result.stderr.strip().rstrip("."))
    return Picture.of_ppm(picture)


def shown(options: argparse.Namespace, folder: Path) -> Picture:
    """What the emulator itself shows."""
    emulator = Emulator(options.emulator + [options.image], folder)
    try:
        return emulator.screen(folder / "screen")
    finally:
        emulator.end()


def last_frame(program: str, folder: Path) -> Picture:
    subprocess.run([program], check=True, stdout=subprocess.DEVNULL, env=os.environ | {"SHADE16_FRAMES": str(folder)})
    frames = sorted(folder.glob("[0-9]*.ppm"), key=lambda file: int(file.stem))
    return Picture.of_ppm(frames[-1])


def must_be_alike(seen: Picture, drawn: Picture, bits: list[int]) -> None:
    if (seen.width, seen.height) != (drawn.width, drawn.height):
        raise ValueError(f"the display shows {seen.width}x{seen.height} pixels, the frame has {drawn.width}x{drawn.height}")
    for y in range(drawn.height):
        for x in range(drawn.width):
            codes = [[value >> (8 - bit) for value, bit in zip(picture.pixel(x, y), bits)] for picture in (seen, drawn)]
            if codes[0] != codes[1]:
                raise ValueError(f"the pixel at {x}, {y} shows {codes[0]}, and the frame has {codes[1]}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bits", type=int, nargs=3, required=True, help="of red, green and blue")
    parser.add_argument("--program", required=True, help="the app on this computer")
    parser.add_argument("--image", required=True, help="the app on the board")
    parser.add_argument("--keep", type=Path, help="where a picture of the display goes")
    parser.add_argument("--kept", type=Path, help="the picture of the display that must still be it")
    parser.add_argument("--model", nargs=3, metavar=("DECODER", "PANEL", "TURNS"), help="instead of the emulator's own screen")
    parser.add_argument("emulator", nargs="+", help="the command that runs an image, which follows")
    options = parser.parse_args()
    try:
        pixels = compare(options)
    except ValueError as error:
        print(f"The display is not what this computer draws: {error}.", file=sys.stderr)
        return 1
    print(f"All {pixels} pixels of the display are those of the frame.")
    return 0


def compare(options: argparse.Namespace) -> int:
    """The number of pixels, all of which are alike."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        drawn = last_frame(options.program, folder)
        seen = decoded(options, folder) if options.model else shown(options, folder)
        if options.keep:
            options.keep.write_bytes(seen.png())
        if options.kept and Picture.of_png(options.kept).rgb != seen.rgb:
            raise ValueError(f"{options.kept} shows another picture; run 'scripts/boards.sh --pictures'")
        must_be_alike(seen.every(max(1, seen.width // drawn.width)), drawn, options.bits)
        return drawn.width * drawn.height


if __name__ == "__main__":
    sys.exit(main())
